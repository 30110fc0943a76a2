using Alate.Catalogue;
using NUnit.Framework;
using Unity.StandIns;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Tests of a crowd.</summary>
    public abstract class CrowdFixture : PlayFixture
    {
        internal CrowdScene Scene { get; set; }

        /// <inheritdoc/>
        protected override bool KeepsParts => true;

        // Of every test, as parts that one of them makes stay for the others: crowds need wings with their material.
        [SetUp]
        public void AddTheShaderOfWings() => ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");

        [TearDown]
        public void ClearScene()
        {
            KeepParts();
            Scene?.Clear();
            Scene = null;
            ProjectShaders.Clear();
        }
    }
}
