// Depth pass of a shadow map: nothing but depth is written.
void main()
{
}
