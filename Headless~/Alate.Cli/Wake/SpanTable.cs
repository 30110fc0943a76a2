using static Alate.Formats.CsvTable;

namespace Alate.Cli;

/// <summary>span.csv: circulation, force and moving air along the span of each wing over the last beat, in axes of the body.</summary>
internal static class SpanTable
{
    private static readonly string[] s_Header =
    [
        "turn", "wing", "span", "circulation_m2_s", "force_x_n_m", "force_y_n_m", "force_z_n_m", "inflow_x_m_s", "inflow_y_m_s",
        "inflow_z_m_s",
    ];

    /// <summary>Rows: each strip of each wing at each step. Where the flight is symmetric the right wings alone.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(WakeFlight wake, IReadOnlyList<WakeMoment> beat)
    {
        yield return s_Header;
        foreach (WakeMoment at in beat)
        {
            for (int k = 0; k < at.Wings.Count; k++)
            {
                foreach (WakeStrip strip in at.Wings[k].Strips)
                {
                    yield return
                    [
                        Number(at.Turns), wake.Wings[k].SideAndName, Number(strip.Span), Number(strip.Circulation),
                        Number(strip.Force.x), Number(strip.Force.y), Number(strip.Force.z), Number(strip.Inflow.x),
                        Number(strip.Inflow.y), Number(strip.Inflow.z),
                    ];
                }
            }
        }
    }
}
