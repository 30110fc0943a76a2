namespace Alate.Files
{
    /// <summary>A key of an object of a file.</summary>
    internal class FileKey
    {
        /// <param name="name">With its unit in words.</param>
        /// <param name="shape">The value.</param>
        /// <param name="help">One or two sentences.</param>
        public FileKey(string name, FileShape shape, string help)
        {
            Name = name;
            Shape = shape;
            Help = help;
        }

        /// <summary>Name of the key, with its unit in words.</summary>
        public string Name { get; }

        /// <summary>The value.</summary>
        public FileShape Shape { get; }

        /// <summary>One or two sentences.</summary>
        public string Help { get; }

        /// <summary>True for a key that every such object must have.</summary>
        public bool IsNeeded { get; set; }
    }
}
