using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>
    /// Layout of a texture of a baked insect: a column a vertex, its frames below one another; when the columns run out, the next block of
    /// rows begins. Normals lie in the lower half, in a place like that of the position, or in a texture of their own.
    /// </summary>
    public readonly struct BakeLayout
    {
        /// <summary>Side of the largest texture that all devices take.</summary>
        public const int DefaultMaxSize = 4096;

        /// <summary>Bounds of the largest side that may be asked for.</summary>
        public const int MinMaxSize = 64, MaxMaxSize = 16384;

        private BakeLayout(int vertexCount, int frameCount, int width, bool holdsNormals)
        {
            VertexCount = vertexCount;
            FrameCount = frameCount;
            Width = width;
            HoldsNormals = holdsNormals;
        }

        /// <summary>Columns that are used: vertices of the insect.</summary>
        public int VertexCount { get; }

        /// <summary>Rows of a block: frames of all clips.</summary>
        public int FrameCount { get; }

        /// <summary>Pixels from side to side.</summary>
        public int Width { get; }

        /// <summary>True where the lower half holds normals.</summary>
        public bool HoldsNormals { get; }

        /// <summary>Blocks of rows.</summary>
        public int Blocks => (VertexCount + Width - 1) / Width;

        /// <summary>Pixels from top to bottom.</summary>
        public int Height => Blocks * FrameCount * (HoldsNormals ? 2 : 1);

        /// <summary>The smallest texture whose width is a power of two and at least its height, or as wide as may be.</summary>
        /// <param name="vertexCount">Vertices of the insect.</param>
        /// <param name="frameCount">Frames of all clips.</param>
        /// <param name="maxSize">Longest side, pixels.</param>
        /// <param name="holdsNormals">Whether the lower half holds normals.</param>
        /// <exception cref="BakeException">The texture would be too large; says how large, and what to do.</exception>
        public static BakeLayout Fit(int vertexCount, int frameCount, int maxSize, bool holdsNormals)
        {
            var layout = new BakeLayout(vertexCount, frameCount, 1, holdsNormals);
            while (layout.Width < layout.Height && 2 * layout.Width <= maxSize)
                layout = new BakeLayout(vertexCount, frameCount, 2 * layout.Width, holdsNormals);
            if (layout.Height <= maxSize)
                return layout;
            throw new BakeException(
                $"{vertexCount} vertices at {frameCount} frames need a texture of {layout.Width} x {layout.Height} pixels; at most "
                + $"{maxSize} x {maxSize} are allowed: bake fewer frames or clips at once, or allow a larger texture.");
        }

        /// <summary>Column and row, from the upper left, of a vertex's position at a frame.</summary>
        public int2 PixelOf(int vertex, int frame) => new int2(vertex % Width, vertex / Width * FrameCount + frame);

        /// <summary>Rows from a position to its normal.</summary>
        public int NormalRows => Height / 2;

        /// <summary>
        /// Coordinates of a vertex's first frame, from the lower left: the middle of its pixel. Frame k lies k rows further down.
        /// </summary>
        public float2 CoordinatesOf(int vertex)
        {
            int2 pixel = PixelOf(vertex, 0);
            return new float2((pixel.x + 0.5f) / Width, 1f - (pixel.y + 0.5f) / Height);
        }
    }
}
