using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>The public API, a line a member, as it was looked at last: a change of it is meant, and seen in a review.</summary>
    public sealed class PublicApiTests
    {
        private const BindingFlags k_Own = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static | BindingFlags.Instance
            | BindingFlags.DeclaredOnly;

        private static string Snapshot =>
            Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Architecture", "PublicApi.txt");

        [Test]
        public void ThePublicApi_IsThatOfTheSnapshot()
        {
            List<string> now = Lines();
            if (Environment.GetEnvironmentVariable("ALATE_WRITE_API") == "1")
                File.WriteAllLines(Snapshot, now);

            Assert.That(now, Is.EqualTo(File.ReadAllLines(Snapshot)), "ALATE_WRITE_API=1 writes the snapshot.");
        }

        [Test]
        public void OfGeometry_NothingIsPublic() => Assert.That(Assembly.Load("Alate.Geometry").GetExportedTypes(), Is.Empty);

        [Test]
        public void EveryPublicTypeOfTheFirstVersion_IsFoundByItsOldName()
        {
            var found = new HashSet<string>();
            foreach (Type type in Rooms.Assemblies.Keys.SelectMany(assembly => Assembly.Load(assembly).GetExportedTypes()))
            {
                CustomAttributeData moved = type.GetCustomAttributesData()
                    .FirstOrDefault(data => data.AttributeType.Name == "MovedFromAttribute");
                string Argument(int index, string present) => moved?.ConstructorArguments[index].Value as string ?? present;
                if (Argument(1, type.Namespace) == "Alate" && Argument(2, type.Assembly.GetName().Name) == "Alate")
                    found.Add(Argument(3, type.Name));
            }

            Assert.That(s_FirstVersion.Except(found), Is.Empty);
        }

        [Test]
        public void TypesThatWereWithdrawn_AreInternal([ValueSource(nameof(s_NowInternal))] string name)
        {
            Type[] types = Rooms.Assemblies.Keys.SelectMany(assembly => Assembly.Load(assembly).GetTypes())
                .Where(type => type.Name == name).ToArray();
            Assert.That(types, Has.Length.EqualTo(1));
            Assert.That(types[0].IsVisible, Is.False);
        }

        private static List<string> Lines()
        {
            var lines = new List<string>();
            foreach (string assembly in Rooms.Assemblies.Keys)
            {
                foreach (Type type in Assembly.Load(assembly).GetExportedTypes())
                {
                    string name = $"{assembly}: {type.FullName}";
                    lines.Add(name);
                    lines.AddRange(type.GetMembers(k_Own).Where(IsShown).Select(member => $"{name}.{Signature(member)}"));
                }
            }

            lines.Sort(StringComparer.Ordinal);
            return lines.Distinct().ToList();
        }

        private static bool IsShown(MemberInfo member) => member switch
        {
            MethodBase method => (method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly)
                && (!method.IsSpecialName || method is ConstructorInfo),
            FieldInfo field => (field.IsPublic || field.IsFamily) && !field.IsSpecialName,
            PropertyInfo property => property.GetAccessors(true).Any(accessor => accessor.IsPublic || accessor.IsFamily),
            EventInfo @event => @event.AddMethod.IsPublic,
            _ => false,
        };

        private static string Signature(MemberInfo member) => member switch
        {
            PropertyInfo property => $"{property} {{{(property.GetMethod?.IsPublic == true ? " get;" : "")}"
                + $"{(property.SetMethod?.IsPublic == true ? " set;" : "")} }}",
            FieldInfo { IsLiteral: true } constant => $"{constant} = {constant.GetRawConstantValue()}",
            _ => member.ToString(),
        };

        // Parts of the measurements and of the catalogue that nobody outside can need.
        private static readonly string[] s_NowInternal =
        [
            "EdgeLag", "EdgeStretch", "GeneratedInsect", "MonarchPattern", "SectionCamber", "SectionTwist", "TipBend", "TipLag",
            "WingSection",
        ];

        private static readonly string[] s_FirstVersion =
        [
            "AirTangent", "BeatFrame", "BeatMeasurement", "CoefficientSet", "ComparisonColumn", "CycleChange",
            "InsectAir", "InsectBody", "InsectFactory", "InsectMotion", "InsectProblem",
            "InsectQuality", "InsectState", "InsectSteering", "InsectWings", "JointChain", "ModelOptions", "ModelPreset",
            "OrbitCamera", "ScreenHeights", "SkeletonFit", "SkeletonFitSettings",
            "SkeletonFitWarning", "SkeletonFitWarningKind", "SkeletonFitter", "SkeletonGenerator", "SkeletonJson", "SkeletonProblem",
            "SkeletonProblemKind", "SkinnedVertex", "SkinnedWingConversion", "SkinnedWingResult", "Species", "SpeciesBeat",
            "SpeciesDefinition", "SpeciesSize", "SpeciesSource", "SpeciesStiffness", "SpeciesVariant", "SpeciesWave", "SpeciesWing",
            "Spring", "SpringUnits", "StepClock", "SurfaceMesh", "TeleportResponse", "TorqueArm",
            "VelocitySource", "Wing", "WingCulling", "WingDeformation", "WingDetail", "WingFinder", "WingFrame", "WingHandle",
            "WingMaterial", "WingMesher", "WingOutline", "WingPair", "WingParameterRange", "WingParameters", "WingPart", "WingPattern",
            "WingPicture", "WingPlacement", "WingReading", "WingRig", "WingRigSettings", "WingSide", "WingSkeleton",
            "WingSpecies", "WingSurroundings", "WingSystem", "WingTrace", "WingTracer", "WingTracingSettings",
            "WingUpdateMode", "WingWorld",
        ];
    }
}
