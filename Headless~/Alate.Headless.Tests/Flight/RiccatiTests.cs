using System;
using Alate.Flight;
using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Factorization;
using NUnit.Framework;
using Complex = System.Numerics.Complex;

namespace Alate.Tests.FreeFlights
{
    public sealed class RiccatiTests
    {
        [Test]
        public void Gains_AreThoseOfTheStableEigenvectors([Range(1, 20)] int seed)
        {
            var random = new Random(seed);
            int n = 2 + seed % 9, m = 1 + seed % 4;
            Matrix<double> a = Fill(random, n, n) * 0.9, b = Fill(random, n, m);
            double[] q = new double[n];
            for (int k = 0; k < n; k++)
                q[k] = 0.1 + random.NextDouble();

            double[,] gains = Riccati.Gains(a.ToArray(), b.ToArray(), q);

            Matrix<double> p = Stable(a, b, Matrix<double>.Build.DenseOfDiagonalArray(q));
            Matrix<double> expected = (Matrix<double>.Build.DenseIdentity(m) + b.Transpose() * p * b).Solve(b.Transpose() * p * a);
            Assert.That((Matrix<double>.Build.DenseOfArray(gains) - expected).L2Norm(), Is.LessThan(1e-6 * (1 + expected.L2Norm())));
            foreach (Complex value in (a - b * expected).Evd().EigenValues)
                Assert.That(value.Magnitude, Is.LessThan(1));
        }

        [Test]
        public void AnUnstableStateThatNoCommandReaches_HasNoGains()
        {
            Assert.That(
                Riccati.Gains(new double[,] { { 2, 0 }, { 0, 0.5 } }, new double[,] { { 0 }, { 1 } }, new double[] { 1, 1 }), Is.Null);
        }

        // P grows with Q where the commands shrink by the root: smaller units change nothing but the gains' own unit.
        [Test]
        public void Gains_KeepTheirShape_WhateverTheUnitOfTheCost([Values(1e-16, 1e-8, 1e8)] double unit)
        {
            var random = new Random(9);
            Matrix<double> a = Fill(random, 5, 5) * 0.9, b = Fill(random, 5, 2);
            double[] q = { 1, 0.5, 2, 0.1, 0.3 };
            Matrix<double> gains = Matrix<double>.Build.DenseOfArray(Riccati.Gains(a.ToArray(), b.ToArray(), q));
            double[] small = Array.ConvertAll(q, weight => unit * weight);
            Matrix<double> other = Matrix<double>.Build.DenseOfArray(Riccati.Gains(a.ToArray(), (b / Math.Sqrt(unit)).ToArray(), small));

            Assert.That((other / Math.Sqrt(unit) - gains).L2Norm(), Is.LessThan(1e-8 * gains.L2Norm()));
        }

        // P of the invariant subspace inside the unit circle of the pencil x' = …: independent of the doubling.
        private static Matrix<double> Stable(Matrix<double> a, Matrix<double> b, Matrix<double> q)
        {
            int n = a.RowCount;
            Matrix<double> g = b * b.Transpose(), inverse = a.Transpose().Inverse();
            Matrix<double> symplectic = (a + g * inverse * q).Append(-g * inverse).Stack((-inverse * q).Append(inverse));
            Evd<double> parts = symplectic.Evd();
            Matrix<Complex> basis = Matrix<Complex>.Build.Dense(2 * n, n);
            // Complex eigenvectors come in pairs of columns, real and imaginary part.
            int column = 0;
            for (int k = 0; k < 2 * n; k++)
            {
                Complex value = parts.EigenValues[k];
                if (value.Magnitude >= 1)
                    continue;
                Matrix<Complex> shifted = symplectic.ToComplex() - Matrix<Complex>.Build.DenseDiagonal(2 * n, 2 * n, value + 1e-9);
                Vector<Complex> vector = Vector<Complex>.Build.Dense(2 * n, i => new Complex(1 + i % 3, i % 2));
                for (int round = 0; round < 4; round++)
                {
                    vector = shifted.Solve(vector);
                    vector /= vector.L2Norm();
                }

                basis.SetColumn(column++, vector);
            }

            Matrix<Complex> upper = basis.SubMatrix(0, n, 0, n), lower = basis.SubMatrix(n, n, 0, n);
            return (lower * upper.Inverse()).Map(value => value.Real);
        }

        private static Matrix<double> Fill(Random random, int rows, int columns) =>
            Matrix<double>.Build.Dense(rows, columns, (_, _) => 2 * random.NextDouble() - 1);
    }
}
