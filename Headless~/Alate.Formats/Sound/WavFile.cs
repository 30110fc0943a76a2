namespace Alate.Formats;

/// <summary>Writes sound as a WAV file: one channel, 16 bits.</summary>
internal static class WavFile
{
    private const int k_BytesPerSample = 2;

    /// <summary>Writes samples.</summary>
    /// <param name="stream">Takes the file.</param>
    /// <param name="samples">From −1 to 1; what is beyond is cut off.</param>
    /// <param name="rate">Samples a second.</param>
    public static void Write(Stream stream, ReadOnlySpan<float> samples, int rate)
    {
        using var file = new BinaryWriter(stream, Encoding.ASCII, leaveOpen: true);
        int bytes = samples.Length * k_BytesPerSample;
        file.Write("RIFF"u8);
        file.Write(36 + bytes);
        file.Write("WAVEfmt "u8);
        file.Write(16);

        // Uncompressed, one channel.
        file.Write((short)1);
        file.Write((short)1);
        file.Write(rate);
        file.Write(rate * k_BytesPerSample);
        file.Write((short)k_BytesPerSample);
        file.Write((short)(8 * k_BytesPerSample));
        file.Write("data"u8);
        file.Write(bytes);
        foreach (float sample in samples)
            file.Write((short)Math.Round(short.MaxValue * Math.Clamp(sample, -1f, 1f)));
    }
}
