using System;
using System.IO;

namespace Alate.Files
{
    /// <summary>Reads the files that an insect file names.</summary>
    internal abstract class FileSource
    {
        /// <summary>Returns true where there is a file.</summary>
        public abstract bool Contains(string path);

        /// <summary>Reads a text file.</summary>
        /// <param name="path">Its path.</param>
        /// <param name="read">Reads the text.</param>
        /// <exception cref="UserException">There is no such file, it cannot be read, or the reader found a
        /// <see cref="FormatException"/>; the message begins with the path.</exception>
        public abstract T ReadText<T>(string path, Func<TextReader, T> read);

        /// <summary>Reads a mesh, which may be larger than other texts.</summary>
        /// <inheritdoc cref="ReadText{T}"/>
        public abstract T ReadMesh<T>(string path, Func<TextReader, T> read);

        /// <summary>Reads a picture that <c>ImageConversion.LoadImage</c> takes.</summary>
        /// <param name="path">A PNG or JPEG file.</param>
        /// <exception cref="UserException">There is no such file, or it is no such picture.</exception>
        public abstract byte[] ReadPicture(string path);

        /// <summary>
        /// Makes what follows from files alone, such as the shape of a wing. A source for insects that differ in numbers alone keeps it, so
        /// that nobody may change it.
        /// </summary>
        /// <param name="key">What is made and the files that it follows from, equal where they are the same.</param>
        /// <param name="make">Makes it.</param>
        public virtual T Make<T>(object key, Func<T> make) => make();
    }
}
