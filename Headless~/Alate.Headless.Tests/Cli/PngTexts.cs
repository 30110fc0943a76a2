using System;
using System.Buffers.Binary;
using System.IO;
using System.Text;

namespace Alate.Tests.Cli
{
    /// <summary>What a picture says of the texts in it, for those who do not see it.</summary>
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
