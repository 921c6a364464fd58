/* PLUG: broken */ void f( { ] @ "text
 /* never closed