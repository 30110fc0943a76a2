namespace Alate.Editor
{
    /// <summary>Faults that keep an insect from flying, or from flying where it should.</summary>
    internal enum FlightFault
    {
        None,
        Wings,
        NoBody,
        BadBody,
        NoTrims,
        OtherNumbers,
        PilotFailed,
        NoPilot,
    }
}
