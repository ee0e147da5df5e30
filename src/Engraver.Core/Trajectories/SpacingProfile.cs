namespace Engraver.Core.Trajectories;

/// <summary>Allowed spacing of the points of a spline along a chain (sace-xps-agie.md 3.5 step 1), on a grid of cells that is fine near joints.</summary>
internal sealed class SpacingProfile
{
    /// <summary>Constant of the error of third order, sqrt(3)/108 (sace-xps-agie.md 3.1).</summary>
    private const double ThirdOrder = 0.016037507477489603;

    /// <summary>Weight of the error of fourth order where the spacing changes, because the greatest errors of both orders are not at the same place of a
    /// step.</summary>
    private const double FourthOrderShare = 0.64;

    /// <summary>A joint counts when its error at the spacing around it could reach this fraction of the allowed error.</summary>
    private const double JointShare = 0.1;

    /// <summary>At a corner that is a control point the deviation is 2/27 h |sin(turn)| (sace-xps-agie.md 3.3).</summary>
    private const double CornerFactor = 13.5 * 0.9;

    /// <summary>Longest step in radians of turn.</summary>
    private const double MaxTurn = 1.4;

    private readonly SmoothChain _chain;
    private readonly double[] _from;
    private readonly double[] _width;
    private readonly double[] _curvature;
    private readonly double[] _change;
    private readonly double[] _boost;
    private readonly double[] _most;
    private readonly double[] _perError;
    private readonly double[] _affine;
    private double _affinePart = double.NaN;

    public SpacingProfile(SmoothChain chain)
    {
        _chain = chain;
        var (from, width, curvature, pieces) = (new List<double>(), new List<double>(), new List<double>(), new List<int>());
        for (var i = 0; i < chain.Pieces.Count; i++)
        {
            var piece = chain.Pieces[i];
            var cells = piece.IsFree ? 6 : piece.IsLine ? 40 : 24;
            for (var cell = 0; cell < cells; cell++)
            {
                var (start, end) = (Fraction(piece, cell, cells), Fraction(piece, cell + 1, cells));
                var (low, high) = (piece.LengthAt(start), piece.LengthAt(end));
                if (!(high > low)) continue;
                from.Add(low);
                width.Add(high - low);
                curvature.Add(piece.At((start + end) / 2.0).Curvature);
                pieces.Add(i);
            }
        }

        (_from, _width, _curvature) = ([.. from], [.. width], [.. curvature]);
        (_change, _boost, Spacing) = (new double[_from.Length], new double[_from.Length], new double[_from.Length]);
        (_most, _perError, _affine) = (new double[_from.Length], new double[_from.Length], new double[_from.Length]);
        Differentiate(pieces);
        MeasureCurvature();
    }

    /// <summary>Spacing for each cell, millimetres.</summary>
    public double[] Spacing { get; }

    /// <summary>Fixed positions of knots, in order: corners and ends at a knot, jumps of curvature in the middle of a step.</summary>
    public List<KnotBreak> Breaks { get; } = [];

    /// <summary>A profile with equal steps of at most this length.</summary>
    public void FillEvenly(double spacing)
    {
        Array.Fill(Spacing, spacing);
        Array.Fill(_boost, 1.0);
        Breaks.Clear();
    }

    /// <summary>The first family: the largest spacing that the error allows, within limits of growth; the second: proportional to curvature to the power -1/3,
    /// softened at a fraction of the mean curvature.</summary>
    /// <param name="error">Target error of the spacing, millimetres.</param>
    /// <param name="growth">Largest change of spacing for each millimetre.</param>
    /// <param name="soft">Null for the first family.</param>
    public void Fill(double error, double growth, double? soft)
    {
        Array.Fill(_boost, 1.0);
        Breaks.Clear();
        if (soft is { } part) FillAffine(error, part);
        else FillByError(error);
        LimitAtJoints(error);
        Limit(error, growth, forwards: true, third: soft is null);
        Limit(error, growth, forwards: false, third: soft is null);
    }

    /// <summary>Makes points denser between two lengths.</summary>
    public void Boost(double from, double to, double factor)
    {
        if (_chain.Closed && from < 0.0) Boost(from + _chain.Length, _chain.Length, factor);
        if (_chain.Closed && to > _chain.Length) Boost(0.0, to - _chain.Length, factor);
        for (var i = Math.Max(0, CellAt(from)); i < _from.Length && _from[i] < to; i++) _boost[i] *= factor;
    }

    /// <summary>Number of steps between two lengths, not yet rounded.</summary>
    public double Steps(double from, double to)
    {
        var sum = 0.0;
        for (var i = Math.Max(0, CellAt(from)); i < _from.Length && _from[i] < to; i++)
        {
            var (low, high) = (Math.Max(from, _from[i]), Math.Min(to, _from[i] + _width[i]));
            if (high > low) sum += (high - low) * Density(i);
        }

        return sum;
    }

    /// <summary>The lengths at which equal shares of the steps between two lengths end: share number k is first + k for every whole k.</summary>
    /// <param name="first">Share of the first place, in steps, above 0.</param>
    /// <param name="count">Total number of steps.</param>
    public IEnumerable<double> Places(double from, double to, double first, double count)
    {
        var all = Steps(from, to);
        var (done, next) = (0.0, first);
        for (var i = Math.Max(0, CellAt(from)); i < _from.Length && _from[i] < to; i++)
        {
            var (low, high) = (Math.Max(from, _from[i]), Math.Min(to, _from[i] + _width[i]));
            if (!(high > low)) continue;
            var share = (high - low) * Density(i) / all * count;
            while (next < done + share && next < count - 1e-9)
            {
                yield return low + ((next - done) / share * (high - low));
                next += 1.0;
            }

            done += share;
        }

        while (next < count - 1e-9)
        {
            yield return to;
            next += 1.0;
        }
    }

    private double Density(int cell) => _boost[cell] / Spacing[cell];

    private int CellAt(double length)
    {
        var found = Array.BinarySearch(_from, length);
        return found >= 0 ? found : ~found - 1;
    }

    private static double Fraction(ChainPiece piece, int cell, int cells) => piece.IsFree ? (double)cell / cells : (1.0 - Math.Cos(Math.PI * cell / cells)) / 2.0;

    private void Differentiate(List<int> pieces)
    {
        for (var i = 0; i < _from.Length; i++)
        {
            var before = i > 0 && AreOne(pieces[i - 1], pieces[i]) ? i - 1 : i;
            var after = i + 1 < _from.Length && AreOne(pieces[i], pieces[i + 1]) ? i + 1 : i;
            var apart = Middle(after) - Middle(before);
            _change[i] = apart > 0.0 ? (_curvature[after] - _curvature[before]) / apart : 0.0;
        }
    }

    private bool AreOne(int before, int after) => before == after || (_chain.Pieces[before].IsFree && _chain.Pieces[after].IsFree);

    private double Middle(int cell) => _from[cell] + (_width[cell] / 2.0);

    private double Longest => _chain.Closed ? _chain.Length / 4.0 : _chain.Length;

    private void FillByError(double error)
    {
        for (var i = 0; i < Spacing.Length; i++) Spacing[i] = OfError(error, i);
    }

    private double OfError(double error, int cell) => Math.Min(_most[cell], _perError[cell] * Math.Sqrt(Math.Sqrt(error)));

    /// <summary>For each cell the longest step that its turn allows, and the factor of the fourth root of the error: (128 error / (3 |k|^3))^(1/4).</summary>
    private void MeasureCurvature()
    {
        for (var i = 0; i < _curvature.Length; i++)
        {
            var curvature = Math.Abs(_curvature[i]);
            if (curvature * Longest < 1e-9) (_most[i], _perError[i]) = (Longest, double.PositiveInfinity);
            else (_most[i], _perError[i]) = (Math.Min(Longest, MaxTurn / curvature), Math.Pow(128.0 / (3.0 * curvature * curvature * curvature), 0.25));
        }
    }

    private void FillAffine(double error, double part)
    {
        if (_affinePart != part) MeasureAffine(part);
        var scale = double.PositiveInfinity;
        for (var i = 0; i < Spacing.Length; i++)
        {
            if (double.IsFinite(_affine[i])) scale = Math.Min(scale, OfError(error, i) / _affine[i]);
        }

        for (var i = 0; i < Spacing.Length; i++) Spacing[i] = double.IsFinite(_affine[i]) ? Math.Min(Longest, scale * _affine[i]) : Longest;
    }

    /// <summary>Steps of equal affine length, softened, up to a factor.</summary>
    private void MeasureAffine(double part)
    {
        var sum = 0.0;
        for (var i = 0; i < _affine.Length; i++) sum += _width[i] * _curvature[i] * _curvature[i];
        var least = part * part * sum / _chain.Length;
        for (var i = 0; i < _affine.Length; i++) _affine[i] = Math.Pow((_curvature[i] * _curvature[i]) + least, -1.0 / 6.0);
        _affinePart = part;
    }

    private void LimitAtJoints(double error)
    {
        foreach (var joint in _chain.Joints)
        {
            var cell = Math.Clamp(CellAt(joint.At), 0, Spacing.Length - 1);
            var before = cell > 0 ? cell - 1 : _chain.Closed ? Spacing.Length - 1 : 0;
            var around = Math.Min(Spacing[cell], Spacing[before]);
            if (joint.IsCorner)
            {
                var sine = joint.Turn.Abs().Degrees > 90.0 ? 1.0 : Math.Abs(joint.Turn.Sin());
                LimitAround(joint.At, 1.0, CornerFactor * error / sine);
                Breaks.Add(new KnotBreak(joint.At, 0.0));
            }
            else if (0.041 * Math.Abs(joint.CurvatureJump) * around * around > JointShare * error)
            {
                LimitAround(joint.At, 0.5, Math.Sqrt(108.0 * error / Math.Abs(joint.CurvatureJump)));
                Breaks.Add(new KnotBreak(joint.At, 0.5));
            }
        }
    }

    private void LimitAround(double at, double steps, double spacing)
    {
        var reach = steps * spacing;
        for (var i = 0; i < Spacing.Length; i++)
        {
            var cell = (Math.Max(0, CellAt(at)) + i) % Spacing.Length;
            if (i > 0 && (cell == 0 && !_chain.Closed || Away(_from[cell], at) > reach)) break;
            Spacing[cell] = Math.Min(Spacing[cell], spacing);
        }

        for (var i = 1; i < Spacing.Length; i++)
        {
            var cell = Math.Max(0, CellAt(at)) - i;
            if (cell < 0 && !_chain.Closed) break;
            cell = (cell + Spacing.Length) % Spacing.Length;
            if (i > 1 && Away(_from[cell] + _width[cell], at) > reach) break;
            Spacing[cell] = Math.Min(Spacing[cell], spacing);
        }
    }

    private double Away(double one, double other)
    {
        var apart = Math.Abs(one - other);
        return _chain.Closed ? Math.Min(apart, _chain.Length - apart) : apart;
    }

    private void Limit(double error, double growth, bool forwards, bool third)
    {
        var count = Spacing.Length;
        for (var step = 1; step < (_chain.Closed ? 2 * count : count); step++)
        {
            var (here, there) = forwards ? ((step - 1) % count, step % count) : (count - 1 - ((step - 1) % count), count - 1 - (step % count));
            var h = Spacing[here];
            var slope = third ? Math.Min(growth, Slope(error, h, Math.Abs(_curvature[there]), Math.Abs(_change[there]))) : growth;
            Spacing[there] = Math.Min(Spacing[there], h + (slope * (_width[here] + _width[there]) / 2.0));
        }
    }

    /// <summary>Largest growth for which the error of both orders stays within the allowed error.</summary>
    private static double Slope(double error, double h, double curvature, double change)
    {
        if (curvature == 0.0) return double.PositiveInfinity;
        var fourth = FourthOrderShare * 3.0 / 128.0 * h * h * h * h * curvature * curvature * curvature;
        var left = ((error - fourth) / ThirdOrder) - (change * h * h * h);
        return Math.Max(0.02, left / (3.0 * curvature * h * h));
    }
}

/// <summary>A place where knots have a fixed phase.</summary>
/// <param name="At">Length from the start of the chain.</param>
/// <param name="Phase">0 for a knot, 0.5 for the middle of a step.</param>
internal readonly record struct KnotBreak(double At, double Phase);
