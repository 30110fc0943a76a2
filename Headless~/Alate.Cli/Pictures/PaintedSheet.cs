using System.Collections.Generic;

namespace Alate.Cli.Pictures;

/// <summary>Layers that are seen through alike, from back to front.</summary>
internal sealed record PaintedSheet(Glass Glass, List<PaintedLayer> Layers);
