using System;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Problems of an insect: which are to be mended, and whom they name.</summary>
    public sealed class InsectProblemTests
    {
        [Test]
        public void WhatIsNotAboutAWing_NamesNone()
        {
            foreach ((InsectProblem problem, InsectState state, bool mended) in new[]
            {
                (InsectProblem.None, InsectState.Ready, false), (InsectProblem.Inactive, InsectState.Inactive, false),
                (InsectProblem.Waiting, InsectState.Waiting, false), (InsectProblem.NoSize, InsectState.ZeroScale, true),
                (InsectProblem.Failed(new InvalidOperationException("x")), InsectState.Failed, true),
            })
            {
                Assert.That((problem.State, problem.Wing, problem.IsProblem), Is.EqualTo((state, -1, mended)));
                Assert.That(problem.Of("moth").Message, Does.StartWith("'moth': ").And.EndsWith(problem.Message));
            }

            Assert.That(InsectProblem.Failed(new InvalidOperationException("x")).Message, Does.Contain("InvalidOperationException"));
        }

        [Test]
        public void WhatIsAboutAWing_NamesIt_FromTheFirst([Values(0, 3)] int wing)
        {
            InsectProblem named = new InsectProblem(InsectState.NoMesh, wing, "it has no mesh.").Of("moth");

            Assert.That((named.State, named.Wing), Is.EqualTo((InsectState.NoMesh, wing)));
            Assert.That(named.Message, Is.EqualTo($"'moth', wing {wing}: it has no mesh."));
            Assert.That(default(InsectProblem).Message, Is.Empty);
        }
    }
}
