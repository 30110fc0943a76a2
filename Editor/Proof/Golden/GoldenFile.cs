using System.Collections.Generic;
using System.IO;

namespace Alate.Proof
{
    /// <summary>
    /// Tracks in a file: "ALGD", a version, the number of tracks; of each its name, its things, what is allowed, and its numbers as floats
    /// of 32 bits. All little-endian, texts as .NET's BinaryWriter has them.
    /// </summary>
    internal static class GoldenFile
    {
        private const uint k_Magic = 0x44474C41;
        private const int k_Version = 1, k_MostTracks = 1000, k_MostThings = 100_000, k_MostValues = 10_000_000;

        /// <summary>Writes tracks.</summary>
        public static void Write(Stream stream, IReadOnlyList<GoldenTrack> tracks)
        {
            using (var writer = new BinaryWriter(stream, System.Text.Encoding.UTF8, true))
            {
                writer.Write(k_Magic);
                writer.Write(k_Version);
                writer.Write(tracks.Count);
                foreach (GoldenTrack track in tracks)
                {
                    writer.Write(track.Name);
                    writer.Write(track.Things.Length);
                    foreach (string thing in track.Things)
                        writer.Write(thing);
                    writer.Write(track.Allowed);
                    writer.Write(track.Values.Length);
                    foreach (float value in track.Values)
                        writer.Write(value);
                }
            }
        }

        /// <summary>Reads tracks.</summary>
        /// <exception cref="InvalidDataException">It is no such file, or cut short; says so.</exception>
        public static IReadOnlyList<GoldenTrack> Read(Stream stream)
        {
            try
            {
                using (var reader = new BinaryReader(stream, System.Text.Encoding.UTF8, true))
                {
                    if (reader.ReadUInt32() != k_Magic || reader.ReadInt32() != k_Version)
                        throw new InvalidDataException("The file of golden flights is not one, or of another version.");
                    var tracks = new GoldenTrack[Count(reader, k_MostTracks)];
                    for (int k = 0; k < tracks.Length; k++)
                        tracks[k] = Track(reader);
                    return tracks;
                }
            }
            catch (EndOfStreamException)
            {
                throw new InvalidDataException("The file of golden flights is cut short.");
            }
        }

        private static GoldenTrack Track(BinaryReader reader)
        {
            string name = reader.ReadString();
            string[] things = new string[Count(reader, k_MostThings)];
            for (int k = 0; k < things.Length; k++)
                things[k] = reader.ReadString();
            float allowed = reader.ReadSingle();
            float[] values = new float[Count(reader, k_MostValues)];
            for (int k = 0; k < values.Length; k++)
                values[k] = reader.ReadSingle();
            return new GoldenTrack(name, things, allowed, values);
        }

        private static int Count(BinaryReader reader, int most)
        {
            int count = reader.ReadInt32();
            return count >= 0 && count <= most
                ? count
                : throw new InvalidDataException($"The file of golden flights has a count of {count}; allowed are 0 to {most}.");
        }
    }
}
