namespace UnityEngine.Rendering;

public enum AmbientMode
{
    Skybox = 0,
    Trilight = 1,
    Flat = 3,
    Custom = 4,
}
