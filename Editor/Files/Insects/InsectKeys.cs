using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;

namespace Alate.Files
{
    /// <summary>
    /// Every key of an insect file, described once: the reader, the writer, the schema and the manual's tables go by it.
    /// </summary>
    internal static class InsectKeys
    {
        /// <summary>Version of the format.</summary>
        public const int Version = 1;

        public const string SchemaKey = "$schema", VersionKey = "version", Name = "name", DisplayName = "displayName", Like = "like",
            Kinematics = "kinematics", Wings = "wings", Body = "body", Trims = "trims", Sources = "sources", Variants = "variants",
            Hinge = "hingeMillimetres", Mesh = "mesh", Skeleton = "skeleton", Texture = "texture",
            Flexural = "flexuralStiffnessNewtonSquareMetres", Torsional = "torsionalStiffnessNewtonSquareMetres",
            VeinWidths = "veinWidthsMillimetres", Scale = "scale", MeshUnit = "meshUnitMillimetres", Parts = "parts",
            Centre = "centreMillimetres", HalfAxes = "halfAxesMillimetres", MassShare = "massShare", Swing = "swingDegrees",
            Lowest = "lowestPhaseDegrees", Quantity = "quantity", Value = "value",
            Source = "source", Variant = "variant", Beat = "beat", Rest = "rest", Frequency = "frequencyHertz",
            FrequencyFloor = "frequencyFloor", FlapRange = "flapRangeDegrees", AmplitudeFloor = "amplitudeFloor";

        private const string k_Feet = "The middle of the feet, from the middle of the thorax: right, up, ahead.";

        private static readonly TextShape s_WingName = new TextShape(
                "a name of lower-case letters, digits, spaces and hyphens, such as 'fore wing'", 40, "^[a-z][a-z0-9 -]{0,39}$"),
            s_Path = new TextShape("a path from the folder of this file", 400);

        /// <summary>Numbers of the whole insect, which all its wings have in common.</summary>
        public static IReadOnlyList<PresetKey> OfInsect { get; } = new[]
        {
            PresetKey.Field<PresetSize>(preset => ref preset.Size, "insectMass", "mass",
                "Mass of the whole insect with its wings. Its weight is compared with lift, and a flight carries it."),
            PresetKey.Field<PresetSize>(
                preset => ref preset.Size, "fluidDensity", null, "Density of what the wings beat in: air 1.225, fresh water 998."),
            PresetKey.Field<PresetSize>(preset => ref preset.Size, "gravityShare"),
        };

        /// <summary>Size of one kind of wing.</summary>
        public static IReadOnlyList<PresetKey> OfWing { get; } = new[]
        {
            PresetKey.Field<PresetSize>(preset => ref preset.Size, "wingLength", "length",
                "From the hinge to the tip. The shape of the wing, and with the first wing the body, become as large as that."),
            PresetKey.Field<PresetSize>(preset => ref preset.Size, "wingMass", "mass",
                "Mass of one wing; of a fore and a hind wing together where they are one here."),
        };

        /// <summary>Groups of numbers, for all wings or for one: name, help and keys.</summary>
        public static IReadOnlyList<(string Name, string Help, IReadOnlyList<PresetKey> Keys)> Groups { get; } =
            new (string, string, IReadOnlyList<PresetKey>)[]
            {
                (Beat, "The drive at the root.", Renamed(PresetKey.All<PresetBeat>(preset => ref preset.Beat))),
                ("wave", "Delays with which the drive runs over the wing.",
                    PresetKey.All<PresetWave>(preset => ref preset.Wave).ToArray()),
                ("stiffness", "Resistance to bending and its damping, where EI is not measured.",
                    PresetKey.All<PresetStiffness>(preset => ref preset.Stiffness).ToArray()),
                (Rest, "Posture of the insect that sits.", PresetKey.All<PresetRest>(preset => ref preset.Rest)
                    .Select(key => key.Name.StartsWith("feet", StringComparison.Ordinal) ? key.With(k_Feet) : key).ToArray()),
                ("options", "Choices of the model.",
                    PresetKey.All<ModelOptions>(preset => ref preset.Options).Append(Substeps()).ToArray()),
            };

        private static readonly FileKey[] s_Groups = Groups.Select(
            group => new FileKey(group.Name, new ObjectShape(group.Name, group.Keys.ToArray()), group.Help)).ToArray();

        private static readonly FileKey s_Kinematics = new FileKey(
            Kinematics, s_Path, "File of a prescribed motion, in place of the beat; see the page on kinematics.");

        /// <summary>One kind of wing.</summary>
        public static ObjectShape Wing { get; } = new ObjectShape("wing", Joined(OfWing, new[]
        {
            new FileKey(Hinge, FilePlace.Shape, "Hinge of the right wing, from the middle of the thorax: right, up, ahead."),
            new FileKey(Mesh, s_Path, "Mesh of the wing at rest, an OBJ file in any unit and place. Needs a skeleton."),
            new FileKey(Skeleton, s_Path, "Skeleton in the space of that mesh, as 'skeleton fit' writes it."),
            new FileKey(Texture, s_Path, "PNG or JPEG picture for the texture coordinates of the mesh."),
            new FileKey(Flexural, Chains(1e-15m, 1000m, "newton square metres"),
                "Measured flexural stiffness EI: a list for each chain, from root to tip; an empty one where it is not known."),
            new FileKey(Torsional, Chains(1e-15m, 1000m, "newton square metres"),
                "Measured torsional stiffness GJ, the same way. Needs the flexural one."),
            new FileKey(VeinWidths, Chains(0m, 1e6m, "millimetres"), "Widths of the veins under the chains, the same way; 0 is membrane."),
        }, s_Groups));

        /// <summary>A part of the body as the flight sees it.</summary>
        public static ObjectShape Part { get; } = new ObjectShape(
            "part",
            new FileKey(Centre, FilePlace.Shape, "Middle of the ellipsoid.") { IsNeeded = true },
            new FileKey(HalfAxes, FilePlace.Lengths, "Half axes of the ellipsoid.") { IsNeeded = true },
            new FileKey(MassShare, new NumberShape(0m, 1000m, ""), "Share of the mass without wings; weighed against the sum of all.")
            {
                IsNeeded = true,
            },
            new FileKey(Swing, new NumberShape(0m, 45m, "degrees"),
                "Half of the swing up and down about its front end with every beat: of the abdomen. Without it the part is held."),
            new FileKey(Lowest, new NumberShape(-360m, 360m, "degrees"),
                "Phase of the beat in which a part that swings hangs lowest; 0, where the wings are up, without it."));

        /// <summary>The body.</summary>
        public static ObjectShape BodyKeys { get; } = new ObjectShape(
            "body",
            new FileKey(Scale, new NumberShape(0.001m, 1000m, ""),
                "Size of body, hinges and feet over those of 'like'. Without it they grow with the first wing."),
            new FileKey(Mesh, s_Path, "Mesh of the body, an OBJ file: X to the right, Y up, Z ahead, from the middle of the thorax."),
            new FileKey(MeshUnit, new NumberShape(0.001m, 1000m, "millimetres"), "Millimetres of one unit of that mesh; 1 without it."),
            new FileKey(Parts, new ListShape(Part, 1, 32, "a list of 1 to 32 ellipsoids"),
                "Ellipsoids that carry the mass: they say where its centre lies and how it turns."));

        private static readonly ObjectShape s_VariantWing = new ObjectShape("variantWing", Joined(OfWing, s_Groups));

        private static readonly ObjectShape s_Source = new ObjectShape(
            "source",
            new FileKey(Quantity, new TextShape("the name of a number", 100), "What was measured, such as 'wing length'.")
            {
                IsNeeded = true,
            },
            new FileKey(Value, new TextShape("a value with its unit", 200), "The number with its unit.") { IsNeeded = true },
            new FileKey(Source, new TextShape("a reference", 1000), "The paper, or 'assumed' with the reason.") { IsNeeded = true },
            new FileKey(Variant, new ChoiceShape(VariantNames.ToArray()), "The variant that has this number; standard without it."));

        private static readonly ObjectShape s_Variant = new ObjectShape("variant", Joined(OfInsect, s_Groups, new[]
        {
            new FileKey(Wings, new MapShape(s_VariantWing, s_WingName, "an object with the names of wings"), "Numbers of one wing."),
        }));

        /// <summary>The whole file.</summary>
        public static ObjectShape File { get; } = new ObjectShape("insect", Joined(new[]
        {
            new FileKey(SchemaKey, new TextShape("the address of the schema"), "Address of the schema, for editors; not read."),
            new FileKey(VersionKey, new NumberShape(Version, Version, "", isWhole: true), "Version of this format.") { IsNeeded = true },
            new FileKey(Name, new TextShape("a name of lower-case letters, digits and hyphens", 40, "^[a-z][a-z0-9-]{0,39}$"),
                "Name in the names of files and folders.") { IsNeeded = true },
            new FileKey(DisplayName, new TextShape("a name for people", 60), "Name in pictures and messages; that of the file without it."),
            new FileKey(Like, new ChoiceShape(InsectCatalogue.Names.ToArray()),
                "Insect of the catalogue that has every number, shape, colour and variant which this file does not say.")
            {
                IsNeeded = true,
            },
        }, OfInsect, s_Groups, new[]
        {
            s_Kinematics,
            new FileKey(Wings, new MapShape(Wing, s_WingName, "an object with the names of 1 to 4 kinds of wings"),
                "Every kind of wing, from front to back; each is flown as a right and a left one. A name of a wing of 'like' has its "
                + "shape and numbers; another name needs a mesh. Without this key: all wings of 'like'."),
            new FileKey(Body, BodyKeys, "The body."),
            new FileKey(Trims, s_Path, "Table of trims for flights by its own wings, as 'trim FILE --bake' writes it."),
            new FileKey(Sources, new ListShape(s_Source, 0, 200, "a list of up to 200 sources"), "Where each number comes from."),
            new FileKey(Variants, new ObjectShape("variants", VariantNames.Skip(1).Select(name =>
                new FileKey(name, s_Variant, $"What the variant {name} has otherwise.")).ToArray()),
                "Other numbers of the same insect, for --variant; 'flight' are those by which it flies freely."),
        }));

        /// <summary>Names of the variants, the standard one first.</summary>
        public static IEnumerable<string> VariantNames => Enum.GetValues(typeof(InsectVariant)).Cast<InsectVariant>().Select(Word);

        /// <summary>Name of a variant in a file.</summary>
        public static string Word(InsectVariant variant) => variant.ToString().ToLowerInvariant();

        // As biologists call them.
        private static PresetKey[] Renamed(IEnumerable<PresetKey> keys) =>
            keys.Select(key => key.Named(key.Name.Replace("maxFrequency", "frequency").Replace("maxSpeed", "topSpeed"))).ToArray();

        private static FileKey[] Joined(params IEnumerable<FileKey>[] keys) => keys.SelectMany(some => some).ToArray();

        private static PresetKey Substeps() => new PresetKey(
            "substepsPerBeat", new NumberShape(WingParameters.MinSubsteps, WingParameters.MaxSubsteps, "", isWhole: true),
            "Substeps of one beat.", preset => (decimal)preset.SubstepsPerBeat,
            value =>
            {
                int substeps = (int)FileNumber.ToPreset(value.Text, 1m);
                return preset => preset.SubstepsPerBeat = substeps;
            });

        private static ListShape Chains(decimal least, decimal most, string unit) => new ListShape(
            new ListShape(new NumberShape(least, most, unit), 0, WingSkeleton.MaxJoints, "a list of numbers from root to tip"),
            WingSkeleton.MinChains, WingSkeleton.MaxChains, "a list for each chain");
    }
}
