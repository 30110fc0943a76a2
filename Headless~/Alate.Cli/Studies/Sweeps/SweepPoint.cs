namespace Alate.Cli;

/// <summary>Measures at one value of the parameter.</summary>
/// <param name="Value">Of the parameter.</param>
/// <param name="HasWave">Flown with the deformation wave.</param>
/// <param name="Summary">The numbers of the last beat.</param>
/// <param name="LoadCamberPct">[kind of wing] Swing of the camber that the loads make, % of the chord; see
/// <see cref="BeatMeasurement.CamberBeyond"/>.</param>
internal sealed record SweepPoint(double Value, bool HasWave, FlightSummary Summary, IReadOnlyList<double> LoadCamberPct);
