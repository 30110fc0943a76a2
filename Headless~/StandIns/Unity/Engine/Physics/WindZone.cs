namespace UnityEngine;

public class WindZone : Component, IStateful
{
    public WindZoneMode mode { get; set; }
    public float radius { get; set; } = 20f;
    public float windMain { get; set; } = 1f;
    public float windTurbulence { get; set; } = 1f;
    public float windPulseMagnitude { get; set; } = 0.5f;
    public float windPulseFrequency { get; set; } = 0.01f;

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (WindZone)copy;
        to.mode = mode;
        to.radius = radius;
        to.windMain = windMain;
        to.windTurbulence = windTurbulence;
        to.windPulseMagnitude = windPulseMagnitude;
        to.windPulseFrequency = windPulseFrequency;
    }
}

public enum WindZoneMode
{
    Directional = 0,
    Spherical = 1,
}
