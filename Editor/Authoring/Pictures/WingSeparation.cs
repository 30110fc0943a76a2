using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Tells the one wing of a picture from the ground behind it.</summary>
    internal sealed class WingSeparation
    {
        /// <summary>Least width of the bell that smooths noise, pixels, and its width as a share of the longer side.</summary>
        private const double k_LeastBlur = 0.8, k_BlurShare = 0.0012;

        /// <summary>Least contrast of alpha, shades, at which a half transparent pixel counts.</summary>
        private const double k_AlphaNoise = 32.0;

        /// <summary>
        /// Half widths of gaps in a drawn outline, shares of the longer side, with the gain in enclosed area from which on they are closed.
        /// </summary>
        private static readonly (double Share, double Gain)[] s_Gaps = { (0.004, 1.02), (0.012, 1.08), (0.03, 1.3) };

        /// <summary>Largest half width of those gaps, as a share of the shorter side.</summary>
        private const double k_WidestGap = 0.08;

        /// <summary>Share of the enclosed area that a line drawing covers at most.</summary>
        private const double k_Solid = 0.6;

        /// <summary>Least share of a rim on clear edges, where a gap beside dark cells was closed.</summary>
        private const double k_ClearMargin = 0.8;

        /// <summary>Largest loss of clear rim by which slits are closed: what lies beyond a slit may be no wing.</summary>
        private const double k_LessClear = 0.05;

        /// <summary>Half width of whiskers that are cut off, pixels.</summary>
        private const double k_Whisker = 1.0;

        /// <summary>Area of a part over the largest one's, above which the part counts as another wing.</summary>
        private const double k_OtherWing = 0.25;

        /// <summary>Shortest wing, pixels.</summary>
        private const int k_ShortestWing = 40;

        /// <summary>
        /// Least thickness of a wing, as a share of its length, over a share of its area; lines are that thick only where some of them
        /// meet.
        /// </summary>
        private const double k_LeastThickness = 0.02, k_ThickShare = 0.5;

        /// <summary>Largest share of the picture that a wing covers; more means a frame, or ground that is not plain.</summary>
        private const double k_MostCover = 0.92;

        /// <summary>Width of an ignored line around the picture, as a share of the longer side.</summary>
        private const double k_Frame = 0.01;

        private readonly EdgeContrast m_Contrast;

        private WingSeparation(EdgeContrast contrast, PixelMask mask)
        {
            m_Contrast = contrast;
            Mask = mask;
        }

        /// <summary>The pixels of the wing, without holes.</summary>
        public PixelMask Mask { get; }

        /// <summary>Share of the wing's rim where it stands out from the ground clearly, 0 to 1.</summary>
        public double ClearRim => m_Contrast.ClearShareOfRim(Mask);

        /// <summary>
        /// Middle of the side where the wing runs out of the picture, pixels, z minus the row; null where the wing is complete.
        /// </summary>
        public PlanPoint? MiddleOfCut
        {
            get
            {
                PlanPoint sum = default;
                int count = 0;
                for (int row = 0; row < Mask.height; row++)
                {
                    int step = row == 0 || row == Mask.height - 1 ? 1 : Mask.width - 1;
                    for (int column = 0; column < Mask.width; column += step)
                    {
                        if (!Mask[column, row])
                            continue;
                        sum += new PlanPoint(column + 0.5, -(row + 0.5));
                        count++;
                    }
                }

                return count > 0 ? sum * (1.0 / count) : (PlanPoint?)null;
            }
        }

        /// <summary>Finds the wing.</summary>
        /// <exception cref="FormatException">There is none, more than one, or it cannot be told from the ground.</exception>
        public static WingSeparation Of(WorkingPicture picture)
        {
            double blur = Math.Max(k_LeastBlur, k_BlurShare * Math.Max(picture.Width, picture.Height));
            if (picture.HasTransparentGround)
                return Of(picture, new EdgeContrast(picture.Alpha.Blurred(blur), k_AlphaNoise, blur));
            PixelPlane[] channels = { picture.Red.Blurred(blur), picture.Green.Blurred(blur), picture.Blue.Blurred(blur) };
            var ground = PlainGround.FromBorder(channels);
            PixelMask spared = new EdgeContrast(ground.Distance, ground.Noise, blur).excess.Above(0f).Filled().Grown(4.0 * blur);
            // The border alone says little of the middle, where most of the ground may lie.
            if (spared.Count < 0.7 * picture.Width * picture.Height)
                ground = PlainGround.Outside(spared, channels);
            return Of(picture, new EdgeContrast(ground.Distance, ground.Noise, blur));
        }

        /// <summary>
        /// Field that is above 0 within the wing and below 0 outside, passing through 0 on its rim between the centres of two pixels.
        /// </summary>
        public PixelPlane SignedField()
        {
            const float least = 0.5f;
            var field = new PixelPlane(Mask.width, Mask.height);
            for (int row = 0; row < Mask.height; row++)
            {
                for (int column = 0; column < Mask.width; column++)
                {
                    float excess = m_Contrast.excess[column, row];
                    field[column, row] = Mask[column, row] ? Math.Max(excess, least) : Math.Min(excess, -least);
                }
            }

            return field;
        }

        private static WingSeparation Of(WorkingPicture picture, EdgeContrast contrast)
        {
            List<PixelPart> parts = Solid(contrast).Parts();
            if (parts.Count == 0)
                throw new FormatException("No wing was found: nothing in the picture stands out from its ground.");
            int length = parts[0].Extent;
            if (length < k_ShortestWing)
            {
                throw new FormatException(
                    "No wing was found: the largest thing in the picture is "
                    + $"{length * picture.Factor} pixels long; a wing needs at least {k_ShortestWing * picture.Factor}.");
            }

            if (parts[0].Count > k_MostCover * picture.Width * picture.Height || parts[0].SidesReached(picture.Height) > 2)
                return WithoutFrame(picture, contrast);
            PixelMask mask = parts[0].ToMask(picture.Height);
            if (!IsThick(mask))
                throw new FormatException("No wing was found: the picture shows lines, but none that closes around a wing.");
            int wings = parts.FindAll(part => part.Count > k_OtherWing * parts[0].Count && part.Extent >= k_ShortestWing).Count;
            if (wings > 1)
                throw new FormatException($"The picture shows {wings} wings or other things of similar size; it must show one wing alone.");
            return new WingSeparation(contrast, mask);
        }

        // A line around the picture encloses everything.
        private static WingSeparation WithoutFrame(WorkingPicture picture, EdgeContrast contrast)
        {
            PixelPlane excess = contrast.excess;
            int band = 1 + (int)(k_Frame * Math.Max(picture.Width, picture.Height));
            bool hadFrame = false;
            for (int row = 0; row < picture.Height; row++)
            {
                for (int column = 0; column < picture.Width; column++)
                {
                    bool isInside = column >= band && row >= band && column < picture.Width - band && row < picture.Height - band;
                    hadFrame |= !isInside && excess[column, row] > 0f;
                    excess[column, row] = isInside ? excess[column, row] : Math.Min(-1f, excess[column, row]);
                }
            }

            return hadFrame
                ? Of(picture, contrast)
                : throw new FormatException("No wing was found: the picture has no plain ground around the wing.");
        }

        private static PixelMask Solid(EdgeContrast contrast)
        {
            PixelMask mask = contrast.excess.Above(0f), filled = CutWing.Closed(mask).Filled();
            bool isThick = IsThick(filled), isDrawn = !isThick || mask.Count < k_Solid * filled.Count;
            if (!isDrawn && mask.Count >= k_Solid * WithoutGap(mask, s_Gaps[s_Gaps.Length - 1].Share).Count)
            {
                PixelMask whole = CutWing.Closed(contrast.WithoutSlits(mask)).Filled();
                filled = contrast.ClearShareOfRim(whole) > contrast.ClearShareOfRim(filled) - k_LessClear ? whole : filled;
            }
            else
            {
                foreach ((double share, double gain) in s_Gaps)
                {
                    PixelMask closed = WithoutGap(mask, share);

                    // Where part of a wing is dark, its other margins are lines, which are clear too.
                    bool isMargin = isDrawn || contrast.ClearShareOfRim(closed) > k_ClearMargin;
                    filled = closed.Count > gain * filled.Count && isMargin ? closed : filled;
                }

                isThick = IsThick(filled);
            }

            return isThick ? filled.Shrunk(k_Whisker).Grown(k_Whisker) : filled;
        }

        private static PixelMask WithoutGap(PixelMask mask, double share)
        {
            double radius = 1.0 + Math.Min(share * Math.Max(mask.width, mask.height), k_WidestGap * Math.Min(mask.width, mask.height));
            return mask.Grown(radius).Filled().Shrunk(radius);
        }

        // Whether it is more than lines.
        private static bool IsThick(PixelMask mask)
        {
            List<PixelPart> parts = mask.Parts();
            if (parts.Count == 0)
                return false;
            double radius = Math.Max(1.0, 0.5 * k_LeastThickness * parts[0].Extent);
            double least = k_ThickShare * parts[0].Count;
            PixelMask core = parts[0].ToMask(mask.height).Shrunk(radius);
            return core.Count > least || core.Grown(radius).Count > least;
        }
    }
}
