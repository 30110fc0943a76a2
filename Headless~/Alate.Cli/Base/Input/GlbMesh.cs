using SharpGLTF.Schema2;
using SharpGLTF.Validation;
using UnityEngine;
using Matrix4x4 = System.Numerics.Matrix4x4;
using Vector2 = UnityEngine.Vector2;
using Vector3 = UnityEngine.Vector3;

namespace Alate.Cli;

/// <summary>All triangles of a GLB file (glTF 2.0) as one mesh at rest, in metres: X to the right of the insect, Y up, Z ahead.</summary>
/// <param name="Surface">The mesh; without texture coordinates where some of it has none, without colours where all of it is white.</param>
/// <param name="Picture">PNG or JPEG of the first material that has one; null for none.</param>
internal sealed record GlbMesh(SurfaceMesh Surface, byte[] Picture)
{
    /// <summary>True for the name of such a file.</summary>
    public static bool IsNamed(string file) => string.Equals(Path.GetExtension(file), ".glb", StringComparison.OrdinalIgnoreCase);

    /// <summary>Reads a file. Skins and shapes stay at rest; what is no triangle is left out.</summary>
    /// <exception cref="UserException">It cannot be read, or has no triangle.</exception>
    public static GlbMesh Read(string file)
    {
        using FileStream stream = InputFile.Open(file, InputFile.Mesh);
        try
        {
            // What is wrong with a file is found where it is read, so that small faults of other parts do not matter.
            var model = ModelRoot.ReadGLB(stream, ValidationMode.Skip);
            return Of(model.DefaultScene ?? model.LogicalScenes.FirstOrDefault())
                ?? throw new UserException($"{file}: the file has no triangles.");
        }
        catch (Exception problem) when (problem is not UserException)
        {
            throw new UserException($"{file} is no GLB file that can be read: {problem.Message.Split('\n')[0].Trim()}");
        }
    }

    /// <summary>The mesh as a Wavefront OBJ file.</summary>
    public byte[] ToObj()
    {
        using var stream = new MemoryStream();
        ObjWriter.Write(Surface, stream);
        return stream.ToArray();
    }

    private static GlbMesh Of(Scene scene)
    {
        var parts = new Parts();
        if (scene != null)
        {
            foreach (Node node in Node.Flatten(scene).Where(node => node.Mesh != null))
            {
                foreach (MeshPrimitive primitive in node.Mesh.Primitives)
                    parts.Add(primitive, node.WorldMatrix);
            }
        }

        return parts.IsEmpty ? null : new GlbMesh(parts.ToSurface(), parts.Picture);
    }

    private sealed class Parts
    {
        private readonly List<Vector3> m_Positions = [];
        private readonly List<Vector2> m_Uvs = [];
        private readonly List<Color32> m_Colours = [];
        private readonly List<int> m_Triangles = [];
        private bool m_IsMapped = true;

        public bool IsEmpty => m_Triangles.Count == 0;

        public byte[] Picture { get; private set; }

        public void Add(MeshPrimitive primitive, Matrix4x4 place)
        {
            int first = m_Positions.Count;
            (int A, int B, int C)[] triangles = [.. primitive.GetTriangleIndices()];
            if (triangles.Length == 0)
                return;
            Accessor positions = primitive.GetVertexAccessor("POSITION") ?? throw new FormatException("a mesh has no positions");
            foreach (System.Numerics.Vector3 position in positions.AsVector3Array())
            {
                // The mirror of the axes is its own inverse.
                var world = System.Numerics.Vector3.Transform(position, place);
                m_Positions.Add(FileAxes.ToGltf(new float3(world.X, world.Y, world.Z)));
            }

            int count = m_Positions.Count - first;
            if (m_Positions.Skip(first).Any(position => !float.IsFinite(position.x + position.y + position.z)))
                throw new FormatException("a position is no finite number");
            AddUvs(primitive, count);
            AddColours(primitive, count);

            // Mirrored once by the axes, and again by a node that is a mirror.
            bool isTurned = place.GetDeterminant() > 0f;
            foreach ((int a, int b, int c) in triangles)
            {
                if (Math.Min(a, Math.Min(b, c)) < 0 || Math.Max(a, Math.Max(b, c)) >= count)
                    throw new FormatException("a triangle has a vertex that is not there");
                m_Triangles.AddRange(isTurned ? [first + a, first + c, first + b] : [first + a, first + b, first + c]);
            }
        }

        public SurfaceMesh ToSurface() => new()
        {
            positions = [.. m_Positions],
            uvs = m_IsMapped ? [.. m_Uvs] : null,
            colours = m_Colours.TrueForAll(colour => colour.r == 255 && colour.g == 255 && colour.b == 255) ? null : [.. m_Colours],
            triangles = [.. m_Triangles],
        };

        // glTF counts rows from above.
        private void AddUvs(MeshPrimitive primitive, int count)
        {
            MaterialChannel? paint = primitive.Material?.FindChannel("BaseColor");
            Accessor coordinates = primitive.GetVertexAccessor($"TEXCOORD_{paint?.TextureCoordinate ?? 0}");
            m_IsMapped &= coordinates != null;
            if (m_IsMapped)
                m_Uvs.AddRange(coordinates.AsVector2Array().Take(count).Select(uv => new Vector2(uv.X, 1f - uv.Y)));
            Picture ??= paint?.Texture?.PrimaryImage?.Content.Content.ToArray();
        }

        private void AddColours(MeshPrimitive primitive, int count)
        {
            System.Numerics.Vector4 tint = primitive.Material?.FindChannel("BaseColor")?.Color ?? System.Numerics.Vector4.One;
            IReadOnlyList<System.Numerics.Vector4> own =
                primitive.GetVertexAccessor("COLOR_0") is { } colours ? [.. colours.AsColorArray()] : null;
            for (int k = 0; k < count; k++)
            {
                System.Numerics.Vector4 light = own == null ? tint : tint * own[k];
                m_Colours.Add(new Color32(
                    FileColours.Encoded(light.X), FileColours.Encoded(light.Y), FileColours.Encoded(light.Z), 255));
            }
        }
    }
}
