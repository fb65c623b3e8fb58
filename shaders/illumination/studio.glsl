// A small photo studio for mirrors to show: a dark floor with a fine grid, a pale cove behind it, and three soft boxes.
// d is a unit vector that points away from the object; the value is the radiance that arrives from there.
// The same text runs in core/illumination.

// A rectangular lamp around the unit direction `centre`; `across` and `upwards` span its plane. Sizes are measured on
// the plane at distance 1, so straight edges look straight. Brighter in the middle, as cloth over a lamp is.
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
    return 1.0 - smoothstep(0.012, 0.05, abs(x - floor(x) - 0.5));
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
    vec3 ground = mix(vec3(0.025, 0.027, 0.031), vec3(0.24, 0.24, 0.25), smoothstep(-0.9, -0.05, d.y));
    vec3 cove = mix(vec3(0.78, 0.78, 0.79), vec3(0.10, 0.115, 0.14), smoothstep(0.02, 0.70, d.y));
    // The cove stands behind the object; the side of the viewer lies in the dark.
    float backdrop = mix(0.36, 1.0, smoothstep(-0.50, 0.75, -d.z));
    vec3 room = backdrop * mix(ground, cove, smoothstep(-0.14, 0.05, d.y)) + floorGrid(d) * vec3(0.055, 0.055, 0.06);
    float key = softBox(d, vec3(-0.66, 0.22, 0.7183), vec3(0.7364, 0.0, 0.6766), vec3(0.1489, 0.9755, -0.1620),
                        0.42, 0.84);
    float rim = softBox(d, vec3(0.80, 0.20, -0.5657), vec3(0.5774, 0.0, 0.8165), vec3(-0.1633, 0.9798, 0.1155),
                        0.17, 0.80);
    float fill = softBox(d, vec3(0.28, 0.96, 0.0), vec3(0.96, -0.28, 0.0), vec3(0.0, 0.0, 1.0), 0.20, 0.34);
    return room + key * vec3(6.0, 5.8, 5.5) + rim * vec3(3.6, 3.8, 4.0) + fill * vec3(2.2, 2.2, 2.2);
}
