using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    public sealed class BrokenSkeletonTests
    {
        [Test]
        public void Messages_AreSingleSentences()
        {
            foreach (int seed in Enumerable.Range(0, 200))
            {
                foreach (SkeletonProblem problem in Broken(new Random(seed)).Validate())
                    Assert.That(problem.ToString(), Does.EndWith(".").And.Not.Contain("\n"));
            }
        }

        [Test]
        public void WhateverTheContent_NothingThrows()
        {
            var kinds = new HashSet<SkeletonProblemKind>();
            for (int seed = 0; seed < 3000; seed++)
            {
                WingSkeleton skeleton = Broken(new Random(seed));
                List<SkeletonProblem> problems = null;
                Assert.DoesNotThrow(() => problems = skeleton.Validate(), $"seed {seed}");
                kinds.UnionWith(problems.Select(p => p.Kind));
                foreach (SkeletonProblem problem in problems)
                {
                    Assert.That(problem.Chain, Is.InRange(SkeletonProblem.None, skeleton.ChainCount - 1), $"seed {seed}");
                    if (problem.Joint != SkeletonProblem.None)
                        Assert.DoesNotThrow(() => skeleton.GetJoint(problem.Chain, problem.Joint), $"seed {seed}");
                }
            }

            Assert.That(kinds, Has.Count.GreaterThanOrEqualTo(10), "the content was not broken in enough ways");
        }

        // A fan with anything wrong: numbers of chains and joints, missing arrays, wild, equal or exchanged joints, wild axes.
        private static WingSkeleton Broken(Random random)
        {
            WingSkeleton skeleton = TestWings.Fan(random.Next(1, 18), random.Next(1, 18));
            if (random.Next(2) == 0)
                skeleton = TestWings.Fan(random.Next(3, 6), random.Next(3, 6));
            for (int fault = random.Next(1, 4); fault > 0 && skeleton.ChainCount > 0; fault--)
            {
                ref JointChain chain = ref skeleton.Chains[random.Next(skeleton.ChainCount)];
                switch (random.Next(9))
                {
                    case 0:
                        chain.joints = null;
                        break;
                    case 1 when chain.Length > 0:
                        chain.joints[random.Next(chain.Length)] = Wild(random);
                        break;
                    case 2 when chain.Length > 0:
                        chain.joints[random.Next(chain.Length)] = chain.joints[random.Next(chain.Length)];
                        break;
                    case 3:
                        chain.joints = skeleton.Chains[random.Next(skeleton.ChainCount)].joints;
                        break;
                    case 4:
                        (chain, skeleton.Chains[0]) = (skeleton.Chains[0], chain);
                        break;
                    case 5:
                        skeleton.SpanAxis = Wild(random);
                        break;
                    case 6:
                        skeleton.UpAxis = Wild(random);
                        break;
                    case 7:
                        skeleton.Hinge = Wild(random);
                        break;
                    case 8:
                        skeleton.Chains = skeleton.Chains.Take(random.Next(skeleton.ChainCount + 1)).ToArray();
                        break;
                }
            }

            return skeleton;
        }

        private static Vector3 Wild(Random random)
        {
            float[] values =
            {
                0f, 1f, -1f, 0.3f, 1e-30f, float.NaN, float.PositiveInfinity, float.MaxValue, -float.MaxValue, float.Epsilon,
            };
            float Any() => values[random.Next(values.Length)];
            return new Vector3(Any(), Any(), Any());
        }
    }
}
