namespace Alate.Drawing;

/// <summary>Look of a curve of a <see cref="PointChart"/>; looks differ without their colours.</summary>
internal enum CurveLook
{
    /// <summary>Drawn through, a disc at each point.</summary>
    Discs,

    /// <summary>Dashed, a hollow square at each point.</summary>
    Squares,

    /// <summary>Drawn through, without marks.</summary>
    Plain,

    /// <summary>Dashed, without marks.</summary>
    Dashed,

    /// <summary>Thin, without marks.</summary>
    Thin,

    /// <summary>Dotted, without marks: a bound.</summary>
    Dotted,

    /// <summary>Small discs, without a line.</summary>
    Dots,
}
