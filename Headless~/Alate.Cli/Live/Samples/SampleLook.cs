namespace Alate.Cli;

/// <summary>Turn of the camera of a sample, by a hand on the page.</summary>
/// <param name="Number">Of the message: the page draws what is on its way already.</param>
/// <param name="Yaw">Degrees to the side.</param>
/// <param name="Pitch">Degrees down.</param>
/// <param name="Zoom">Factor of the distance.</param>
/// <param name="Move">Way of the point that is looked at, units of the scene.</param>
internal sealed record SampleLook(uint Number, float Yaw, float Pitch, float Zoom, float3 Move);
