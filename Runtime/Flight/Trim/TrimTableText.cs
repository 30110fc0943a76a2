using System;
using System.IO;

namespace Alate.Flight
{
    /// <summary>A trim table as a line of text, small enough for a source file: base 64 of a header and the points' numbers.</summary>
    internal static class TrimTableText
    {
        /// <summary>Version; tables of another one are made again.</summary>
        public const int Version = 2;

        /// <summary>Writes a table.</summary>
        /// <param name="table">The table.</param>
        /// <param name="key">Of the insect that it was made for.</param>
        public static string Write(TrimTable table, uint key)
        {
            using var stream = new MemoryStream();
            using var writer = new BinaryWriter(stream);
            writer.Write(Version);
            writer.Write(key);
            writer.Write((byte)table.Speeds.Length);
            writer.Write((byte)table.ClimbRates.Length);
            foreach (float speed in table.Speeds)
                writer.Write(speed);
            foreach (float climb in table.ClimbRates)
                writer.Write(climb);
            for (int s = 0; s < table.Speeds.Length; s++)
            {
                for (int c = 0; c < table.ClimbRates.Length; c++)
                {
                    writer.Write(table.IsClosed(s, c));
                    for (int k = 0; table.IsClosed(s, c) && k < TrimPoint.Floats; k++)
                        writer.Write(table.Point(s, c)[k]);
                }
            }

            writer.Flush();
            return Convert.ToBase64String(stream.ToArray());
        }

        /// <summary>Reads a table.</summary>
        /// <param name="text">What <see cref="Write"/> made.</param>
        /// <param name="key">Of the insect that it is wanted for.</param>
        /// <returns>The table; null where the text is none, or one of another insect, other parameters or another version.</returns>
        public static TrimTable Read(string text, uint key)
        {
            try
            {
                using var reader = new BinaryReader(new MemoryStream(Convert.FromBase64String(text ?? "")));
                if (reader.ReadInt32() != Version || reader.ReadUInt32() != key)
                    return null;
                float[] speeds = new float[reader.ReadByte()];
                float[] climbs = new float[reader.ReadByte()];
                Fill(reader, speeds);
                Fill(reader, climbs);
                var table = new TrimTable(speeds, climbs);
                for (int s = 0; s < speeds.Length; s++)
                {
                    for (int c = 0; c < climbs.Length; c++)
                    {
                        if (!reader.ReadBoolean())
                            continue;
                        float[] point = new float[TrimPoint.Floats];
                        Fill(reader, point);
                        table.Set(s, c, point);
                    }
                }

                return table.Fill() ? table : null;
            }
            catch (Exception problem) when (problem is FormatException || problem is IOException)
            {
                return null;
            }
        }

        private static void Fill(BinaryReader reader, float[] values)
        {
            for (int k = 0; k < values.Length; k++)
                values[k] = reader.ReadSingle();
        }
    }
}
