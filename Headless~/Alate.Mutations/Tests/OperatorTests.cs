using System.Linq;
using Alate.Mutations.Sources;
using NUnit.Framework;

namespace Alate.Mutations.Tests;

[TestFixture]
internal sealed class OperatorTests
{
    [TestCase("float F(float a, float b) => a - b;", "sign: a - b -> a + b", "dropped term: a - b -> a")]
    [TestCase("float F(float a) => -a;", "sign: -a -> a")]
    [TestCase("float F(float a, float b) => a * b;", "dropped term: a * b -> a")]
    [TestCase("bool F(int a, int b) => a < b;", "comparison: a < b -> a >= b", "comparison: a < b -> a <= b")]
    [TestCase("bool F(float a, float b) => a < b;", "comparison: a < b -> a >= b")]
    [TestCase("bool F(bool a, bool b) => a && b;", "comparison: a && b -> a || b", "dropped term: a && b -> a")]
    [TestCase("bool F(bool a) => !a;", "comparison: !a -> a")]
    [TestCase("float F() => 0.5f;", "constant: 0.5f -> 0.55f")]
    [TestCase("float F() => 0f;", "constant: 0f -> 1f")]
    [TestCase("int F() => 7;", "constant: 7 -> 8")]
    [TestCase("void F(List<int> a) => a.Sort();", "dropped statement: a.Sort(); -> (nothing)")]
    [TestCase("float m; void Reset(float a) { m = a; }", "history not reset: m = a; -> (nothing)")]
    [TestCase("double F(double a, double b) => Math.Pow(a, b);", "swapped: Math.Pow(a, b) -> Math.Pow(b, a)")]
    [TestCase("float F(Vector3 a) => a.X + a.y;", "sign: a.X + a.y -> a.X - a.y", "dropped term: a.X + a.y -> a.X", "swapped: a.y -> a.z")]
    [TestCase("double F(double a) => a * 1000;", "unit factor: a * 1000 -> a", "constant: 1000 -> 1100d")]
    [TestCase("double F(double a) => Math.Clamp(a, -a, a);", "clamp skipped: Math.Clamp(a, -a, a) -> a",
        "swapped: Math.Clamp(a, -a, a) -> Math.Clamp(-a, a, a)", "swapped: Math.Clamp(a, -a, a) -> Math.Clamp(a, a, -a)", "sign: -a -> a")]
    [TestCase("double F(double a, double b) => Math.Max(a, b);", "clamp skipped: Math.Max(a, b) -> a",
        "clamp skipped: Math.Max(a, b) -> b")]
    [TestCase("int F(int[] a, int i) => a[i];", "off by one: i -> i + 1")]
    [TestCase("int F(int n) => n - 1;", "off by one: n - 1 -> n")]
    [TestCase("void F(int n) { for (int i = 0; i < n; i++) { } }", "off by one: 0 -> 0 + 1", "off by one: i < n -> i <= n")]
    public void AnOperator_ChangesWhatItShould(string member, params string[] changes) =>
        Assert.That(Changes(member), Is.EquivalentTo(changes));

    [TestCase("[Obsolete(\"\", 1 < 2)] void F() { }")]
    [TestCase("void F(int a = 3) { }")]
    [TestCase("bool F(int a) => a is 3;")]
    [TestCase("void F(float a) => throw new ArgumentException((a - 1f).ToString());")]
    [TestCase("int m; public override int GetHashCode() => m * 31;")]
    [TestCase("object F() => new List<int>(8);")]
    public void ConstantsMessagesAndSizes_AreLeftAlone(string member) => Assert.That(Changes(member), Is.Empty);

    [Test]
    public void AConstant_ChangesWhereItIsRead()
    {
        Mutant mutant = Mutants("const float k_A = 2f; float F() => k_A;").Single(one => one.Before == "2f");
        Assert.That(mutant.Sites.Single().Node.ToString(), Is.EqualTo("k_A"));
        Assert.That(mutant.Sites.Single().After, Does.Contain("2.2f"));
    }

    private static string[] Changes(string member) =>
        Mutants(member).Select(mutant => mutant.Title).ToArray();

    private static Mutant[] Mutants(string member)
    {
        var project = Project.Of("Sample", "Sample.cs", $$"""
            using System;
            using System.Collections.Generic;
            struct Vector3 { public float X, y, z; }
            class C { {{member}} }
            """);
        return Mutant.Of(project, project.Compilation.SyntaxTrees.Single(), "Sample.cs").ToArray();
    }
}
