using Alate.Catalogue;
using NUnit.Framework;
using Unity.StandIns;

namespace Alate.Tests.Play.Headless;

/// <summary>Random acts on insects whose shader can deform wings.</summary>
public sealed class GpuActsTests : RandomActsTests
{
    protected override int Acts => 1000;

    [SetUp]
    public void AddTheShader() => ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");

    [TearDown]
    public void TakeTheShader() => ProjectShaders.Clear();
}
