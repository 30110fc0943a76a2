namespace Alate.Cli;

/// <summary>An insect in a frame of a film.</summary>
/// <param name="Turns">Phase of the beat, 0 to 1.</param>
/// <param name="Turn">How the insect is turned.</param>
/// <param name="Way">Middle of its thorax from what the camera looks at, metres.</param>
/// <param name="Trail">Where the middle of the thorax was, from what the camera looks at, metres.</param>
internal readonly record struct FilmMoment(double Turns, quaternion Turn, float3 Way, IReadOnlyList<float3> Trail);
