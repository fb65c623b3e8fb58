// A small photo studio for mirrors to show: a dark floor with a fine grid, a pale cove behind it, and three soft boxes.
// d is a unit vector that points away from the object; the value is the radiance that arrives from there.
// The same text runs in core/illumination.

// A rectangular lamp around the unit direction `centre`; `across` and `upwards` span its plane. Sizes are measured on the
// plane at distance 1, so straight edges look straight. Brighter in the middle, as cloth over a lamp is.
float softBox(vec3 d, vec3 centre, vec3 across, vec3 upwards, float halfWidth, float halfHeight)
{
    float depth = dot(d, centre);
    float away = max(depth, 0.05);
    float u = abs(dot(d, across)) / (away * halfWidth);
    float v = abs(dot(d, upwards)) / (away * halfHeight);
    float inside = (1.0 - smoothstep(0.82, 1.08, u)) * (1.0 - smoothstep(0.82, 1.08, v));
    return gate(depth, inside * (1.0 - 0.18 * (min(u, 1.1) * min(u, 1.1) + min(v, 1.1) * min(v, 1.1))));
}

// A line midway between whole numbers: 1 on it, 0 beyond its soft rim.
float gridLine(float x)
{
    return 1.0 - smoothstep(0.015, 0.055, abs(x - floor(x) - 0.5));
}

// Seen on the plane y = -1.2: squares of side 0.6, the object above the middle of one. Fades out before the lines get
// finer than a mirror can show.
float floorGrid(vec3 d)
{
    float scale = 2.0 / max(-d.y, 0.05);
    float x = d.x * scale;
    float z = d.z * scale;
    float fade = 1.0 - smoothstep(2.0, 9.0, sqrt(x * x + z * z));
    return gate(-d.y, fade * max(gridLine(x), gridLine(z)));
}

vec3 studioRadiance(vec3 d)
{
    vec3 ground = mix(vec3(0.035, 0.037, 0.042), vec3(0.17, 0.17, 0.18), smoothstep(-1.0, -0.10, d.y));
    vec3 cove = mix(vec3(0.72, 0.72, 0.73), vec3(0.10, 0.115, 0.14), smoothstep(0.02, 0.70, d.y));
    vec3 room = mix(ground, cove, smoothstep(-0.14, 0.05, d.y)) + floorGrid(d) * vec3(0.13, 0.13, 0.14);
    float key = softBox(d, vec3(-0.64, 0.48, 0.6), vec3(0.6839, 0.0, 0.7295), vec3(0.3502, 0.8772, -0.3283),
                        0.50, 0.62);
    float rim = softBox(d, vec3(0.80, 0.20, -0.5657), vec3(0.5774, 0.0, 0.8165), vec3(-0.1633, 0.9798, 0.1155),
                        0.17, 0.70);
    float fill = softBox(d, vec3(0.28, 0.96, 0.0), vec3(0.96, -0.28, 0.0), vec3(0.0, 0.0, 1.0), 0.20, 0.34);
    return room + key * vec3(6.0, 5.8, 5.5) + rim * vec3(3.6, 3.8, 4.0) + fill * vec3(2.2, 2.2, 2.2);
}
