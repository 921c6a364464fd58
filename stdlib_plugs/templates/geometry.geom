// Geometry stage: what an author's geometry shader calls to hand on what the vertex stage wrote (thesis, chapter 6).

/* PLUG-DECLARATIONS */

// The output vertex gets all of an input vertex.
void geometryVertexSet(const int index)
{
  /* PLUG: geometry_vertex_set (index) */
}

// The output vertex is cleared, before input vertices are added up.
void geometryVertexZero()
{
  /* PLUG: geometry_vertex_zero () */
}

// An input vertex, scaled, is added to the output vertex.
void geometryVertexAdd(const int index, const float scale)
{
  /* PLUG: geometry_vertex_add (index, scale) */
}
