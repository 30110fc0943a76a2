using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>
    /// Reads the polygons of a Wavefront OBJ file: v (with colours, if any), vt, vn and f with triangles, quads and larger polygons as
    /// fans, also with negative indices, and the name of its materials. Positions are read in double precision. Groups, lines and points
    /// are passed over.
    /// </summary>
    internal sealed class ObjReader
    {
        /// <summary>A mesh farther from the origin than so many of its extents is counted from its middle.</summary>
        private const double k_Far = 100;

        private static readonly char[] s_Spaces = { ' ', '\t' };

        private readonly List<(double X, double Y, double Z)> m_Positions = new List<(double X, double Y, double Z)>();
        private readonly List<Vector3> m_Normals = new List<Vector3>();
        private readonly List<Color32> m_Colours = new List<Color32>();
        private readonly List<Vector2> m_TexturePoints = new List<Vector2>();
        private readonly List<(int Position, int Texture, int Normal)> m_Corners = new List<(int Position, int Texture, int Normal)>();
        private readonly Dictionary<(int Position, int Texture, int Normal), int> m_Vertices =
            new Dictionary<(int Position, int Texture, int Normal), int>();
        private readonly List<int> m_Triangles = new List<int>();
        private bool m_EveryCornerHasNormal = true, m_EveryCornerHasTexture = true;
        private string m_Library;
        private int m_Line;
        private bool m_HasLines;

        private readonly bool m_KeepsSeams;

        private ObjReader(bool keepsSeams)
        {
            m_KeepsSeams = keepsSeams;
        }

        /// <summary>Reads a whole file.</summary>
        /// <exception cref="FormatException">The text is not such a file or has no triangle; the message is one line with the line's
        /// number.</exception>
        public static ObjMesh Read(TextReader text) => Read(text, false);

        /// <summary>
        /// Reads a whole file for a picture on it: where a picture has a seam, each of its sides has vertices of its own.
        /// </summary>
        /// <exception cref="FormatException">As of <see cref="Read(TextReader)"/>.</exception>
        public static ObjMesh ReadTextured(TextReader text) => Read(text, true);

        private static ObjMesh Read(TextReader text, bool keepsSeams)
        {
            var reader = new ObjReader(keepsSeams);
            while (reader.NextLine(text) is string line)
                reader.ReadLine(line);
            return reader.Finish();
        }

        // A line may go on behind a backslash.
        private string NextLine(TextReader text)
        {
            string line = text.ReadLine();
            m_Line++;
            if (line == null || !line.EndsWith('\\'))
                return line;
            var whole = new StringBuilder();
            while (line != null && line.EndsWith('\\'))
            {
                whole.Append(line, 0, line.Length - 1).Append(' ');
                line = text.ReadLine();
                m_Line++;
            }

            return whole.Append(line).ToString();
        }

        private void ReadLine(string line)
        {
            int comment = line.IndexOf('#');
            string[] words = (comment < 0 ? line : line.Substring(0, comment)).Split(s_Spaces, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0)
                return;
            switch (words[0])
            {
                case "v":
                    ReadPosition(words);
                    break;
                case "vn":
                    m_Normals.Add(From(Numbers(words), default));
                    break;
                case "vt":
                    if (words.Length < 3)
                        throw Wrong($"'vt' has {words.Length - 1} numbers, not two");
                    m_TexturePoints.Add(new Vector2((float)Number(words[1]), (float)Number(words[2])));
                    break;
                case "mtllib":
                    m_Library = line.Substring(line.IndexOf("mtllib", StringComparison.Ordinal) + "mtllib".Length).Trim();
                    break;
                case "f":
                    ReadFace(words);
                    break;
                case "l":
                case "p":
                    m_HasLines = true;
                    break;
            }
        }

        private void ReadPosition(string[] words)
        {
            m_Positions.Add(Numbers(words));
            if (words.Length >= 7)
                m_Colours.Add(new Color32(Byte(words[4]), Byte(words[5]), Byte(words[6]), 255));
        }

        private void ReadFace(string[] words)
        {
            if (words.Length < 4)
                throw Wrong($"a face has {words.Length - 1} corner{(words.Length == 2 ? "" : "s")}, not three or more");
            int first = Corner(words[1]), before = Corner(words[2]);
            for (int k = 3; k < words.Length; k++)
            {
                int next = Corner(words[k]);
                m_Triangles.AddRange(new[] { first, before, next });
                before = next;
            }
        }

        private int Corner(string word)
        {
            string[] parts = word.Split('/');
            if (parts.Length > 3)
                throw Wrong($"{Quote.Of(word)} is no corner of a face");
            int position = Index(parts[0], m_Positions.Count, "vertex");
            int texture = parts.Length > 1 && parts[1].Length > 0 ? Index(parts[1], m_TexturePoints.Count, "texture point") : -1;
            int normal = parts.Length > 2 && parts[2].Length > 0 ? Index(parts[2], m_Normals.Count, "normal") : -1;
            m_EveryCornerHasNormal &= normal >= 0;
            m_EveryCornerHasTexture &= texture >= 0;
            (int Position, int Texture, int Normal) key = (position, m_KeepsSeams ? texture : -1, normal);
            if (m_Vertices.TryGetValue(key, out int vertex))
                return vertex;
            vertex = m_Corners.Count;
            m_Corners.Add((position, texture, normal));
            m_Vertices.Add(key, vertex);
            return vertex;
        }

        // Indices count from 1, or back from the last one with -1.
        private int Index(string word, int count, string what)
        {
            if (!int.TryParse(word, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int index) || index == 0)
                throw Wrong($"{Quote.Of(word)} is no index of a {what}");
            int found = index > 0 ? index - 1 : count + index;
            if (found < 0 || found >= count)
                throw Wrong($"there is no {what} {index}, only {count} up to here");
            return found;
        }

        private (double X, double Y, double Z) Numbers(string[] words)
        {
            if (words.Length < 4)
                throw Wrong($"'{words[0]}' has {words.Length - 1} numbers, not three");
            return (Number(words[1]), Number(words[2]), Number(words[3]));
        }

        // Finite in single precision, too.
        private double Number(string word)
        {
            if (double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && float.IsFinite((float)value))
                return value;
            throw Wrong($"{Quote.Of(word)} is no finite number");
        }

        private byte Byte(string word) => (byte)Math.Round(255.0 * Math.Clamp(Number(word), 0.0, 1.0));

        private static Vector3 From((double X, double Y, double Z) place, (double X, double Y, double Z) origin) =>
            new Vector3((float)(place.X - origin.X), (float)(place.Y - origin.Y), (float)(place.Z - origin.Z));

        private (double X, double Y, double Z) FindOrigin()
        {
            (double x, double sizeX) = Middle(place => place.X);
            (double y, double sizeY) = Middle(place => place.Y);
            (double z, double sizeZ) = Middle(place => place.Z);
            double far = k_Far * Math.Max(sizeX, Math.Max(sizeY, sizeZ));
            return Math.Max(Math.Abs(x), Math.Max(Math.Abs(y), Math.Abs(z))) > far ? (x, y, z) : default;
        }

        private (double Middle, double Size) Middle(Func<(double X, double Y, double Z), double> along)
        {
            double low = double.MaxValue, high = double.MinValue;
            foreach ((int position, _, _) in m_Corners)
            {
                low = Math.Min(low, along(m_Positions[position]));
                high = Math.Max(high, along(m_Positions[position]));
            }

            return (0.5 * (low + high), high - low);
        }

        private ObjMesh Finish()
        {
            if (m_Positions.Count == 0)
                throw new FormatException("the mesh is empty: there is no vertex ('v').");
            if (m_Triangles.Count == 0)
            {
                string instead = m_HasLines ? "are only lines or points, no faces" : "is no face";
                throw new FormatException($"the mesh has no triangles: there {instead} ('f').");
            }

            (double X, double Y, double Z) origin = FindOrigin();
            bool coloured = m_Colours.Count == m_Positions.Count;
            return new ObjMesh
            {
                Positions = m_Corners.ConvertAll(corner => From(m_Positions[corner.Position], origin)).ToArray(),
                Origin = origin,
                Normals = m_EveryCornerHasNormal ? m_Corners.ConvertAll(corner => m_Normals[corner.Normal]).ToArray() : null,
                Uvs = m_EveryCornerHasTexture ? m_Corners.ConvertAll(corner => m_TexturePoints[corner.Texture]).ToArray() : null,
                Library = m_Library,
                Colours = coloured ? m_Corners.ConvertAll(corner => m_Colours[corner.Position]).ToArray() : null,
                Triangles = m_Triangles.ToArray(),
            };
        }

        private FormatException Wrong(string reason) => new FormatException($"line {m_Line}: {reason}.");
    }
}
