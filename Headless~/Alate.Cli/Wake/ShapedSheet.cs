using Alate.Wake;

namespace Alate.Cli;

/// <summary>Wake of a wing at a moment, in axes of the body.</summary>
/// <param name="Width">Points of a row.</param>
/// <param name="Points">[row · width + point] Metres, the newest row first.</param>
/// <param name="Circulation">
/// [row · (width − 1) + ring] Γ of the rings between two rows, m²/s; positive as a wing sheds it that the air pushes up.
/// </param>
internal sealed record ShapedSheet(int Width, float3[] Points, float[] Circulation)
{
    /// <summary>Number of rows of points.</summary>
    public int Rows => Points.Length / Width;

    /// <summary>Copies a sheet as it lies.</summary>
    /// <param name="sheet">The sheet.</param>
    /// <param name="length">Metres of its unit of length.</param>
    /// <param name="period">Seconds of its unit of time.</param>
    /// <param name="isLeft">True for a left wing, whose rows run the other way.</param>
    public static ShapedSheet Of(WakeSheet sheet, double length, double period, bool isLeft)
    {
        double factor = (isLeft ? 1.0 : -1.0) * length * length / period;
        var points = new List<float3>();
        var circulation = new List<float>();
        for (int row = 0; row < sheet.RowCount; row++)
        {
            for (int k = 0; k < sheet.PointsPerRow; k++)
                points.Add((float)length * sheet.Point(row, k));
            for (int k = 0; k + 1 < sheet.PointsPerRow && row + 1 < sheet.RowCount; k++)
                circulation.Add((float)factor * sheet.Circulation(row, k));
        }

        return new ShapedSheet(sheet.PointsPerRow, [.. points], [.. circulation]);
    }

    /// <summary>The sheet of the wing on the other side, where both sides are alike.</summary>
    public ShapedSheet Mirrored() => this with { Points = Array.ConvertAll(Points, point => new float3(-point.x, point.y, point.z)) };

    /// <summary>The newest rows.</summary>
    public ShapedSheet Newest(int rows) => rows >= Rows
        ? this
        : this with { Points = Points[..(rows * Width)], Circulation = Circulation[..((rows - 1) * (Width - 1))] };

    /// <summary>Each so-manieth row of points, with the rings behind it.</summary>
    public ShapedSheet Every(int rows)
    {
        int[] kept = [.. Enumerable.Range(0, Rows).Where(row => row % rows == 0)];
        return this with
        {
            Points = [.. kept.SelectMany(row => Points[(row * Width)..((row + 1) * Width)])],
            Circulation = [.. kept.SkipLast(1).SelectMany(row => Circulation[(row * (Width - 1))..((row + 1) * (Width - 1))])],
        };
    }

    /// <summary>
    /// Γ beside a point along the span, of the rings behind a row: the mean of both, or the half of one at the ends; none behind the last.
    /// </summary>
    public float CirculationAt(int row, int point)
    {
        if (row + 1 >= Rows)
            return 0f;
        int ring = row * (Width - 1) + point;
        return 0.5f * ((point > 0 ? Circulation[ring - 1] : 0f) + (point < Width - 1 ? Circulation[ring] : 0f));
    }
}
