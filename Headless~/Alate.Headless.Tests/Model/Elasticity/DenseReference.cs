using System;
using System.Collections.Generic;
using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Double;

namespace Alate.Tests
{
    /// <summary>Minimisation in double precision with dense matrices, written independently of the solver under test.</summary>
    internal sealed class DenseReference
    {
        private readonly int m_Joints;
        private readonly int m_PerChain;
        private readonly IReadOnlyList<Spring> m_Springs;
        private readonly double m_Stiffness;
        private readonly Vector<double> m_Anchors;
        private readonly Vector<double> m_Inertia;

        public DenseReference(int joints, int perChain, IReadOnlyList<Spring> springs, double stiffness, double[] anchors, double[] inertia)
        {
            m_Joints = joints;
            m_PerChain = perChain;
            m_Springs = springs;
            m_Stiffness = stiffness;
            m_Anchors = DenseVector.OfArray(anchors);
            m_Inertia = DenseVector.OfArray(inertia);
        }

        /// <summary>Damped Newton until the gradient is spent.</summary>
        public Vector<double> Minimise(double[] start)
        {
            Vector<double> x = DenseVector.OfArray(start);
            for (int k = 0; k < 200; k++)
            {
                Linearise(x, out Vector<double> gradient, out Matrix<double> hessian);
                Vector<double> step = Solve(hessian, gradient);
                double energy = Energy(x), length = 1.0, slope = gradient * step;
                while (Energy(x + length * step) > energy + 1e-4 * length * slope && length > 1e-10)
                    length *= 0.5;
                x += length * step;
                if (step.InfinityNorm() < 1e-12)
                    break;
            }

            return x;
        }

        public double Energy(Vector<double> x)
        {
            double sum = 0.0;
            for (int k = 0; k < x.Count; k++)
                sum += 0.5 * m_Inertia[k / 3] * (x[k] - m_Anchors[k]) * (x[k] - m_Anchors[k]);
            foreach (Spring spring in m_Springs)
            {
                double stretch = (x.SubVector(3 * spring.a, 3) - x.SubVector(3 * spring.b, 3)).L2Norm() - spring.length;
                sum += 0.5 * m_Stiffness * stretch * stretch;
            }

            return sum;
        }

        // Falls back on shifting the Hessian until it is positive definite: another remedy than the one under test.
        private static Vector<double> Solve(Matrix<double> hessian, Vector<double> gradient)
        {
            for (double shift = 0.0; ; shift = Math.Max(2.0 * shift, 1e-3 * hessian.Diagonal().AbsoluteMaximum()))
            {
                try
                {
                    return -(hessian + shift * DenseMatrix.CreateIdentity(gradient.Count)).Cholesky().Solve(gradient);
                }
                catch (ArgumentException)
                {
                }
            }
        }

        private void Linearise(Vector<double> x, out Vector<double> gradient, out Matrix<double> hessian)
        {
            gradient = new DenseVector(x.Count);
            hessian = new DenseMatrix(x.Count, x.Count);
            for (int k = 0; k < x.Count; k++)
            {
                gradient[k] = m_Inertia[k / 3] * (x[k] - m_Anchors[k]);
                hessian[k, k] = m_Inertia[k / 3];
            }

            foreach (Spring spring in m_Springs)
                AddSpring(spring, x, gradient, hessian);
            for (int root = 0; root < m_Joints; root += m_PerChain)
                Pin(root, gradient, hessian);
        }

        private void AddSpring(Spring spring, Vector<double> x, Vector<double> gradient, Matrix<double> hessian)
        {
            int a = 3 * spring.a, b = 3 * spring.b;
            Vector<double> difference = x.SubVector(a, 3) - x.SubVector(b, 3);
            double length = difference.L2Norm();
            Vector<double> axis = difference / length;
            Matrix<double> outer = axis.OuterProduct(axis);
            Matrix<double> block = m_Stiffness * (outer + (1.0 - spring.length / length) * (DenseMatrix.CreateIdentity(3) - outer));
            Vector<double> force = m_Stiffness * (length - spring.length) * axis;
            gradient.SetSubVector(a, 3, gradient.SubVector(a, 3) + force);
            gradient.SetSubVector(b, 3, gradient.SubVector(b, 3) - force);
            foreach ((int row, int column, double sign) in new[] { (a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0) })
                hessian.SetSubMatrix(row, column, hessian.SubMatrix(row, 3, column, 3) + sign * block);
        }

        private static void Pin(int joint, Vector<double> gradient, Matrix<double> hessian)
        {
            for (int k = 3 * joint; k < 3 * joint + 3; k++)
            {
                gradient[k] = 0.0;
                hessian.ClearRow(k);
                hessian.ClearColumn(k);
                hessian[k, k] = 1.0;
            }
        }
    }
}
