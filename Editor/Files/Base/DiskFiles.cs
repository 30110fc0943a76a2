using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace Alate.Files
{
    /// <summary>Reads files from the disk, up to a size that no such file reaches, and notes their paths.</summary>
    internal sealed class DiskFiles : FileSource
    {
        private const long k_Text = 16L << 20, k_Mesh = 256L << 20, k_Picture = 256L << 20;

        private static readonly byte[] s_Png = { 0x89, 0x50, 0x4E, 0x47 }, s_Jpeg = { 0xFF, 0xD8, 0xFF };

        private readonly List<string> m_Paths = new List<string>();
        private readonly Func<string, string> m_Locate;

        /// <param name="locate">Finds the file of a path; null where paths are those of files.</param>
        public DiskFiles(Func<string, string> locate = null)
        {
            m_Locate = locate ?? (path => path);
        }

        /// <summary>Paths that were asked for, each once, whether or not there was such a file.</summary>
        public IReadOnlyList<string> Paths => m_Paths;

        public override bool Contains(string path) => File.Exists(Located(path));

        public override T ReadText<T>(string path, Func<TextReader, T> read) => Read(path, k_Text, read);

        public override T ReadMesh<T>(string path, Func<TextReader, T> read) => Read(path, k_Mesh, read);

        public override byte[] ReadPicture(string path)
        {
            byte[] bytes = Bytes(path, k_Picture);
            return bytes.AsSpan().StartsWith(s_Png) || bytes.AsSpan().StartsWith(s_Jpeg)
                ? bytes
                : throw new UserException($"Cannot read '{path}': it is neither a PNG nor a JPEG picture.");
        }

        private T Read<T>(string path, long most, Func<TextReader, T> read)
        {
            byte[] bytes = Bytes(path, most);
            try
            {
                using var reader = new StreamReader(new MemoryStream(bytes), new UTF8Encoding(false, true));
                return read(reader);
            }
            catch (DecoderFallbackException)
            {
                throw new UserException($"Cannot read '{path}': it is not a text file in UTF-8.");
            }
            catch (FormatException problem)
            {
                throw new UserException($"{path}: {problem.Message}");
            }
        }

        private byte[] Bytes(string path, long most)
        {
            string file = Located(path);
            try
            {
                if (!File.Exists(file))
                    throw new UserException($"Cannot read '{path}': there is no such file.");
                long length = new FileInfo(file).Length;
                if (length == 0)
                    throw new UserException($"Cannot read '{path}': it is empty.");
                if (length > most)
                    throw new UserException($"Cannot read '{path}': it is larger than {most >> 20} MiB.");
                return File.ReadAllBytes(file);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                throw new UserException($"Cannot read '{path}': {problem.Message}");
            }
        }

        private string Located(string path)
        {
            if (!m_Paths.Contains(path))
                m_Paths.Add(path);
            return m_Locate(path);
        }
    }
}
