using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Files
{
    /// <summary>Reads an insect file: the insect of the catalogue that it is like, with what the file says otherwise.</summary>
    public sealed class InsectFile
    {
        /// <summary>End of the name of such a file.</summary>
        public const string Ending = ".insect.json";

        private static readonly Color32 s_BodyColour = new Color32(112, 96, 80, 255);

        private readonly FileSource m_Files;
        private readonly string m_Path;
        private readonly JsonPlace m_Root;
        private readonly InsectDefinition m_Like;

        private InsectFile(FileSource files, string path, JsonPlace root)
        {
            m_Files = files;
            m_Path = path;
            m_Root = root;
            m_Like = InsectCatalogue.Find(root[InsectKeys.Like].Text);
        }

        /// <summary>Reads a file and those that it names.</summary>
        /// <param name="path">Its path; those that it names lead from its folder.</param>
        /// <returns>The insect, for <see cref="InsectFactory"/> and every other user of the catalogue's insects.</returns>
        /// <exception cref="UserException">One cannot be read; the message names the file, the line, the key and what is
        /// allowed.</exception>
        public static InsectDefinition Read(string path) => Read(path, new DiskFiles());

        /// <summary>Reads a file and those that it names.</summary>
        /// <param name="path">Its path.</param>
        /// <param name="files">Reads all of them.</param>
        /// <exception cref="UserException">One cannot be read; the message names the file, the line, the key and what is
        /// allowed.</exception>
        internal static InsectDefinition Read(string path, FileSource files)
        {
            string all = files.ReadText(path, text => text.ReadToEnd());
            try
            {
                InsectDefinition insect = Read(JsonPlace.Read(new StringReader(all)), path, files);
                (insect.FilePath, insect.FileText) = (path, all);
                return insect;
            }
            catch (FormatException problem)
            {
                throw new UserException($"{path}: {problem.Message}");
            }
        }

        /// <summary>Reads an insect that stands in a file of another kind.</summary>
        /// <param name="root">The insect.</param>
        /// <param name="path">File from whose folder its paths lead.</param>
        /// <param name="files">Reads those that it names.</param>
        /// <exception cref="FormatException">It is none; the message names the line, the key and what is allowed.</exception>
        /// <exception cref="UserException">A file that it names cannot be read.</exception>
        internal static InsectDefinition Read(JsonPlace root, string path, FileSource files)
        {
            InsectKeys.File.Check(root);
            InsectDefinition insect = new InsectFile(files, path, root).Define();
            InsectFileLimits.Check(insect, root);
            return insect;
        }

        private InsectDefinition Define()
        {
            List<(string Name, JsonPlace Said, WingDefinition Model)> kinds = Kinds();
            JsonPlace body = m_Root[InsectKeys.Body];
            double size = body?[InsectKeys.Scale] is { } scale
                ? FileNumber.ToPreset(scale.Text, 1m)
                : Growth(kinds[0].Said, kinds[0].Model);
            List<string> names = kinds.ConvertAll(kind => kind.Name);
            List<WingDefinition> wings = kinds.ConvertAll(kind => Wing(kind.Name, kind.Said, kind.Model, (float)size, names));
            string name = m_Root[InsectKeys.Name].Text, title = char.ToUpperInvariant(name[0]) + name.Substring(1).Replace('-', ' ');
            return new InsectDefinition(
                name, m_Root[InsectKeys.DisplayName]?.Text ?? title, wings, BodyOf(body, (float)size), Sources())
            {
                FlightParts = body?[InsectKeys.Parts] is { } parts
                    ? parts.Items.Select(Part).ToArray()
                    : m_Like.FlightParts.Select(part => part.Scaled((float)size)).ToArray(),
                Trims = m_Root[InsectKeys.Trims] is { } trims
                    ? m_Files.ReadText(Beside(trims), text => text.ReadToEnd())
                    : TrimTables.Of(m_Like),
            };
        }

        // Name, what the file says, and the wing of the catalogue that has the rest.
        private List<(string Name, JsonPlace Said, WingDefinition Model)> Kinds()
        {
            JsonPlace wings = m_Root[InsectKeys.Wings];
            return wings == null
                ? m_Like.Wings.Select(wing => (wing.Name, (JsonPlace)null, wing)).ToList()
                : wings.Members.Select(member => (member.Key, member.Value, ModelOf(member.Key, member.Value))).ToList();
        }

        private WingDefinition ModelOf(string name, JsonPlace said)
        {
            WingDefinition model = m_Like.Wings.FirstOrDefault(wing => wing.Name == name);
            return model != null || said[InsectKeys.Mesh] != null
                ? model ?? m_Like.Wings[0]
                : throw said.Wrong($"the {m_Like.Name} has no such wing, so that it needs a mesh. The {m_Like.Name} has: "
                    + string.Join(", ", m_Like.Wings.Select(wing => wing.Name)));
        }

        private WingDefinition Wing(string name, JsonPlace said, WingDefinition model, float size, List<string> names)
        {
            JsonPlace mesh = said?[InsectKeys.Mesh], skeleton = said?[InsectKeys.Skeleton], texture = said?[InsectKeys.Texture];
            if ((mesh == null) != (skeleton == null))
                throw said.Wrong("'mesh' and 'skeleton' need one another; 'skeleton fit' makes the skeleton of a mesh");
            if (texture != null && mesh == null)
                throw texture.Wrong("a texture needs a mesh");
            double length = mesh == null ? model.Length * Growth(said, model) : Length(said, model);
            (MeshedWing shape, byte[] picture) = mesh == null ? default : m_Files.Make(
                ("wing", mesh.Text, skeleton.Text, texture?.Text), () => ShapeOf(mesh, skeleton, texture));
            var wing = new WingDefinition(name, model, length, shape)
            {
                Hinge = said?[InsectKeys.Hinge] is { } hinge ? FilePlace.Read(hinge) : model.Hinge * size,
                Picture = picture,
            };
            wing.Meshed = m_Files.Make(model, () => wing.Meshed);
            if (size != 1f)
                wing.Change(InsectVariant.Standard, preset => preset.Rest.feet *= size);
            wing.Veins = Veins(said, wing);
            KinematicsFile motion = m_Root[InsectKeys.Kinematics] is { } kinematics
                ? KinematicsFile.Read(Beside(kinematics), names, m_Files)
                : null;
            wing.Change(Changes(m_Root, said, new[] { m_Root, said }) + (preset => motion?.ApplyTo(name, preset)));
            foreach ((string variant, JsonPlace other) in Members(m_Root[InsectKeys.Variants]))
            {
                JsonPlace others = other[InsectKeys.Wings], own = others?[name];
                if (Members(others).FirstOrDefault(member => !names.Contains(member.Key)) is { Value: { } stranger })
                    throw stranger.Wrong($"the insect has no such wing. It has: {string.Join(", ", names)}");
                wing.Change(Enum.Parse<InsectVariant>(variant, true), Changes(other, own, new[] { m_Root, said, other, own }));
            }

            return wing;
        }

        private static IReadOnlyList<(string Key, JsonPlace Value)> Members(JsonPlace place) =>
            place?.Members ?? Array.Empty<(string, JsonPlace)>();

        // What an insect and its wing say of a preset, each number read once. A frequency and a flap that are said are flown at every
        // speed, where the file says no floor.
        private static Action<WingPreset> Changes(JsonPlace insect, JsonPlace wing, JsonPlace[] all)
        {
            JsonPlace[] levels = { insect, wing };
            var changes = new List<Action<WingPreset>>();
            Say(insect, InsectKeys.OfInsect);
            Say(wing, InsectKeys.OfWing);
            if (SaysBeat(levels, InsectKeys.Frequency) && !SaysBeat(all, InsectKeys.FrequencyFloor))
                changes.Add(preset => preset.Beat.frequencyFloor = 1f);
            if (SaysBeat(levels, InsectKeys.FlapRange) && !SaysBeat(all, InsectKeys.AmplitudeFloor))
                changes.Add(preset => preset.Beat.amplitudeFloor = 1f);
            foreach (JsonPlace level in levels)
            {
                foreach ((string name, _, IReadOnlyList<PresetKey> keys) in InsectKeys.Groups)
                    Say(level?[name], keys);
            }

            return preset => changes.ForEach(change => change(preset));

            void Say(JsonPlace said, IEnumerable<PresetKey> keys)
            {
                foreach (PresetKey key in keys)
                {
                    if (said?[key.Name] is { } value)
                        changes.Add(key.Read(value));
                }
            }
        }

        private static bool SaysBeat(JsonPlace[] levels, string key) =>
            Array.Exists(levels, level => level?[InsectKeys.Beat]?[key] != null);

        // Length that is said over that of the model.
        private static double Growth(JsonPlace said, WingDefinition model) => Length(said, model) / (double)model.PresetLength();

        private static float Length(JsonPlace said, WingDefinition model) =>
            said?[InsectKeys.OfWing[0].Name] is { } length ? FileNumber.ToPreset(length.Text, 1000m) : model.PresetLength();

        private static VeinMeasures[] Veins(JsonPlace said, WingDefinition wing)
        {
            JsonPlace flexural = said?[InsectKeys.Flexural], torsional = said?[InsectKeys.Torsional], widths = said?[InsectKeys.VeinWidths];
            foreach (JsonPlace lists in new[] { flexural, torsional, widths })
            {
                if (lists != null && lists.Items.Count != wing.Chains)
                    throw lists.Wrong($"it has {lists.Items.Count} lists; the wing has {wing.Chains} chains");
            }
            if (flexural == null && torsional == null && widths == null)
                return null;
            VeinMeasures[] veins = Enumerable.Range(0, wing.Chains).Select(chain => new VeinMeasures
            {
                flexuralStiffness = Values(flexural, chain),
                torsionalStiffness = Values(torsional, chain),
                veinWidths = Values(widths, chain),
            }).ToArray();
            wing.Veins = veins;
            WingSkeleton skeleton = wing.CreateSkeleton(WingSide.Right);
            List<SkeletonProblem> problems = skeleton.Validate();
            Object.DestroyImmediate(skeleton);
            return problems.Count == 0 ? veins : throw (flexural ?? torsional ?? widths).Wrong(problems[0].Message.TrimEnd('.'));
        }

        private static float[] Values(JsonPlace lists, int chain) =>
            lists?.Items[chain].Items.Select(value => FileNumber.ToPreset(value.Text, 1m)).ToArray();

        private (MeshedWing Shape, byte[] Picture) ShapeOf(JsonPlace mesh, JsonPlace skeleton, JsonPlace texture)
        {
            var files = WingFiles.Read(Beside(mesh), Beside(skeleton), texture == null ? null : Beside(texture), m_Files);
            MeshedWing shape = files.ToShape(Beside(mesh));
            Object.DestroyImmediate(files.Skeleton);
            return (shape, files.Picture);
        }

        private InsectBody BodyOf(JsonPlace body, float size)
        {
            if (body?[InsectKeys.Mesh] is not { } mesh)
            {
                return body?[InsectKeys.MeshUnit] is { } alone
                    ? throw alone.Wrong("it needs a mesh of the body")
                    : m_Like.Body.Scaled(size);
            }

            ObjMesh read = m_Files.Make(("body", mesh.Text), () => m_Files.ReadMesh(Beside(mesh), ObjReader.Read));
            if (read.TriangleCount > WingFiles.MostTriangles)
                throw mesh.Wrong(WingFiles.TooMany(mesh.Text, read).TrimEnd('.'));
            float unit = body[InsectKeys.MeshUnit] is { } said ? FileNumber.ToPreset(said.Text, 1m) : 1f;
            var origin = new Vector3((float)read.Origin.X, (float)read.Origin.Y, (float)read.Origin.Z);
            SurfaceMesh surface = read.ToSurface(m_Path);
            surface.positions = Array.ConvertAll(surface.positions, position => unit * (origin + position));
            var lit = surface.ToMesh(m_Path);
            lit.RecalculateNormals();
            surface.normals = lit.normals;
            Object.DestroyImmediate(lit);
            surface.uvs ??= new Vector2[surface.VertexCount];
            surface.colours = read.Colours ?? Enumerable.Repeat(s_BodyColour, surface.VertexCount).ToArray();
            return new InsectBody(() => surface);
        }

        private static BodyEllipsoid Part(JsonPlace said) => new BodyEllipsoid
        {
            centre = FilePlace.Read(said[InsectKeys.Centre]),
            halfAxes = FilePlace.Read(said[InsectKeys.HalfAxes]),
            share = FileNumber.ToPreset(said[InsectKeys.MassShare].Text, 1m),
            swing = said[InsectKeys.Swing] is { } swing ? FileNumber.ToPreset(swing.Text, 1m) : 0f,
            lowestPhase = said[InsectKeys.Lowest] is { } lowest ? FileNumber.ToPreset(lowest.Text, 1m) : 0f,
        };

        private InsectSource[] Sources() =>
            m_Root[InsectKeys.Sources]?.Items.Select(Source).ToArray() ?? Array.Empty<InsectSource>();

        private static InsectSource Source(JsonPlace said) => new InsectSource(
            said[InsectKeys.Quantity].Text, said[InsectKeys.Value].Text, said[InsectKeys.Source].Text,
            said[InsectKeys.Variant] is { } variant ? Enum.Parse<InsectVariant>(variant.Text, true) : InsectVariant.Standard);

        private string Beside(JsonPlace path) => Path.Combine(Path.GetDirectoryName(m_Path) ?? "", path.Text);
    }
}
