using System;
using System.Buffers.Binary;
using System.IO;
using System.Text;

namespace Alate.Tests.Cli
{
    /// <summary>Texts that a picture names in its metadata, for readers who do not see it.</summary>
    internal static class PngTexts
    {
        public static string[] Of(string path)
        {
            byte[] file = File.ReadAllBytes(path);
            for (int at = 8; at < file.Length;)
            {
                int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
                if (Encoding.ASCII.GetString(file, at + 4, 4) == "iTXt")
                    return Encoding.UTF8.GetString(file, at + 8, length).Split('\0')[^1].Split('\n');
                at += 12 + length;
            }

            return Array.Empty<string>();
        }
    }
}
