namespace Alate.Drawing;

/// <summary>A line of text on a <see cref="PixelPage"/>.</summary>
/// <param name="Text">What is written.</param>
/// <param name="At">Left end of its base line.</param>
/// <param name="Size">Size of the letters.</param>
/// <param name="Anchor">start, middle or end.</param>
/// <param name="Look">t for pale, b for bold, or nothing.</param>
internal readonly record struct PixelWords(string Text, float2 At, float Size, string Anchor, string Look);
