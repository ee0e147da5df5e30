using System.Globalization;
using System.Runtime.InteropServices;
using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>Converts a SPLINE record into its curve. Control points have precedence; a spline with fit points only is interpolated. Announced numbers (72, 73,
/// 74) are not relied on.</summary>
internal sealed class SplineMapper
{
    private const int DegreeWithoutGroup = 3;
    private const int ClosedFlag = 1;

    /// <summary>
    /// Largest allowed ratio of weights. Near a much heavier point nearly the whole curve is in a tiny range of its parameter, which doubles cannot resolve:
    /// from a ratio of 1e8 on lengths were wrong, and at 1e17 the arc fit did not end.
    /// </summary>
    private const double LargestRatio = 1e6 * (1.0 + 1e-12);

    private readonly List<Vector3D> _controls = [];
    private readonly List<Vector3D> _fitPoints = [];
    private readonly List<double> _knots = [];
    private readonly List<double> _weights = [];
    private int _degree;
    private bool _closedFlag;
    private Vector3D? _startTangent;
    private Vector3D? _endTangent;

    /// <summary>Adds the curve to the shape, or gives the record a fault.</summary>
    public void Map(EntityRecord record, CurveShape shape)
    {
        _degree = record.Has(71) ? record.Flags(71) : DegreeWithoutGroup;
        _closedFlag = (record.Flags(70) & ClosedFlag) != 0;
        _startTangent = Tangent(record, 12);
        _endTangent = Tangent(record, 13);
        Sort(CollectionsMarshal.AsSpan(record.Sequence), weightCode: 41);
        Add(record, shape);
    }

    /// <summary>The same for a spline edge of a hatch boundary (DXF reference, "Boundary Path Data"): degree in 94, weights in 42, periodic in 74.</summary>
    public void MapEdge(EntityRecord record, ReadOnlySpan<CodedNumber> edge, CurveShape shape)
    {
        _degree = (int)HatchEdge.Value(edge, 94, DegreeWithoutGroup);
        _closedFlag = false;
        _startTangent = HatchEdge.Vector(edge, 12);
        _endTangent = HatchEdge.Vector(edge, 13);
        Sort(edge, weightCode: 42);
        Add(record, shape);
    }

    private void Add(EntityRecord record, CurveShape shape)
    {
        var isTorn = _controls.Exists(point => double.IsNaN(point.Y)) || _fitPoints.Exists(point => double.IsNaN(point.Y));
        if (isTorn) record.Refuse(DxfRules.MissingValue, record.Line, Wording.Get("SplineMapper.YOfPoint"));
        if (record.Fault is not null) return;
        var curve = _controls.Count > 0 && (_controls.Count > _degree || _fitPoints.Count < 2) ? FromControls(record, shape) : FromFitPoints(record, shape);
        if (curve is null) return;
        shape.Closed = curve.IsClosed;
        shape.Add(curve);
    }

    private static void Note(EntityRecord record, CurveShape shape, DiagnosticRule rule, string detail) =>
        shape.Warnings.Add(record.Finding(rule, detail, refused: false));

    private static Vector3D? Tangent(EntityRecord record, int code) =>
        record.Has(code) ? new Vector3D(record.Number(code, 0.0), record.Number(code + 10, 0.0), record.Number(code + 20, 0.0)) : null;

    private static void Place(List<Vector3D> points, int axis, double value)
    {
        if (axis == 0) points.Add(new Vector3D(value, double.NaN, 0.0));
        else if (points.Count > 0) points[^1] = axis == 1 ? points[^1] with { Y = value } : points[^1] with { Z = value };
    }

    private void Sort(ReadOnlySpan<CodedNumber> pairs, int weightCode)
    {
        _controls.Clear();
        _fitPoints.Clear();
        _knots.Clear();
        _weights.Clear();
        foreach (var (code, value) in pairs)
        {
            if (code is 10 or 20 or 30) Place(_controls, (code / 10) - 1, value);
            else if (code is 11 or 21 or 31) Place(_fitPoints, (code / 10) - 1, value);
            else if (code == 40) _knots.Add(value);
            else if (code == weightCode) _weights.Add(value);
        }
    }

    private RationalCurve? FromControls(EntityRecord record, CurveShape shape)
    {
        if (_degree < 1 || _degree > NurbsCurve.LargestDegree || _controls.Count <= _degree)
        {
            record.Refuse(DxfRules.SplineUnusable, record.Line, Wording.Get("SplineMapper.DegreeAndControlPoints", _degree, _controls.Count));
            return null;
        }

        var (knots, points) = (Knots(record, shape), Homogeneous(record, shape));
        return record.Fault is null ? new NurbsCurve(_degree, knots, points).ToCurve() : null;
    }

    /// <summary>The knots as written, or substitutes. OpenNURBS (Rhino) omits the first and the last knot, on which no point depends: with these two repeated
    /// its clamped curve is exact.</summary>
    private double[] Knots(EntityRecord record, CurveShape shape)
    {
        double[] knots = [.. _knots];
        if (NurbsCurve.AreUsable(knots, _degree, _controls.Count)) return knots;
        double[] completed = IsClamped(knots) ? [knots[0], .. knots, knots[^1]] : [];
        var isTwoShort = NurbsCurve.AreUsable(completed, _degree, _controls.Count);
        var repair = isTwoShort ? Wording.Get("SplineMapper.EndKnotsRepeated", _controls.Count, _degree) : Wording.Get("SplineMapper.UniformKnots", _controls.Count, _degree);
        Note(record, shape, DxfRules.SplineWithoutKnots, repair);
        return isTwoShort ? completed : NurbsCurve.UniformKnots(_degree, _controls.Count);
    }

    /// <summary>True when at each end the number of equal knots is the degree.</summary>
    private bool IsClamped(double[] knots) => knots.Length >= 2 * _degree && knots[0] == knots[_degree - 1] && knots[^1] == knots[^_degree];

    /// <summary>Homogeneous control points. Weights that do not fit, or are not all positive, are ignored: all are taken as 1.</summary>
    private double[] Homogeneous(EntityRecord record, CurveShape shape)
    {
        var largest = _weights.DefaultIfEmpty(1.0).Max(); // only their ratios matter
        var smallest = _weights.DefaultIfEmpty(1.0).Min();
        var weighted = _weights.Count == _controls.Count && smallest > 0.0;
        if (weighted && largest / smallest > LargestRatio) record.Refuse(DxfRules.WeightsTooUnequal, record.Line, string.Create(CultureInfo.InvariantCulture, $"{largest / smallest:G3}"));
        if (!weighted && _weights.Count > 0) Note(record, shape, DxfRules.SplineWeights, Wording.Get("SplineMapper.WeightsAndControlPoints", _weights.Count, _controls.Count));
        var points = new double[_controls.Count * BezierSpan.Stride];
        for (var i = 0; i < _controls.Count; i++)
        {
            var weight = weighted ? _weights[i] / largest : 1.0;
            var point = _controls[i] * weight;
            (points[4 * i], points[(4 * i) + 1], points[(4 * i) + 2], points[(4 * i) + 3]) = (point.X, point.Y, point.Z, weight);
        }

        return points;
    }

    private RationalCurve? FromFitPoints(EntityRecord record, CurveShape shape)
    {
        var closed = _closedFlag;
        var points = new List<Vector3D>();
        foreach (var point in _fitPoints)
        {
            if (points.Count == 0 || VertexRun.AreApart(points[^1], point)) points.Add(point);
        }

        while (closed && points.Count > 1 && !VertexRun.AreApart(points[^1], points[0])) points.RemoveAt(points.Count - 1);
        if (_fitPoints.Count < 2) record.Refuse(DxfRules.SplineUnusable, record.Line, Wording.Get("SplineMapper.FitPointsOnly", _fitPoints.Count));
        if (points.Count < 2) return null;
        Note(record, shape, DxfRules.SplineFromFitPoints, string.Create(CultureInfo.InvariantCulture, $"{_fitPoints.Count}"));
        return FitPointSpline.Through(points, _startTangent, _endTangent, closed && points.Count > 2);
    }
}
