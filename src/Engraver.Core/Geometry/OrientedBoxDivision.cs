namespace Engraver.Core.Geometry;

/// <summary>Divides oriented boxes in two so that the boxes around both halves are small: by position along their common direction, by position across it, or
/// by direction (a hatch is two families of lines).</summary>
internal sealed class OrientedBoxDivision
{
    /// <summary>Below this depth halves get equal numbers of items, so that the depth of the tree is limited for every drawing.</summary>
    private const int DeepestUneven = 40;

    /// <summary>Margin added before areas are compared, as a part of the whole extent: otherwise all boxes without width would have the same area.</summary>
    private const double WeighedMargin = 1e-5;

    /// <summary>The boxes have a common direction when the length of the sum of their directions is at least this part of the sum of their lengths.</summary>
    private const double MinCommon = 0.5;

    private readonly OrientedBox[] _boxes;
    private readonly int[] _order;
    private readonly double[] _keys;
    private readonly List<OrientedBoxNode> _nodes = [];
    private double _margin;

    private OrientedBoxDivision(OrientedBox[] boxes)
    {
        _boxes = boxes;
        _order = new int[boxes.Length];
        for (var i = 0; i < _order.Length; i++) _order[i] = i;
        _keys = new double[boxes.Length];
    }

    public static (int[] Order, List<OrientedBoxNode> Nodes) Divide(OrientedBox[] boxes)
    {
        var division = new OrientedBoxDivision(boxes);
        if (boxes.Length > 0) division.AddRoot();
        return (division._order, division._nodes);
    }

    private void AddRoot()
    {
        var common = new CommonCourse();
        foreach (var box in _boxes) common.Add(box);
        var extent = Fitted(0, _boxes.Length, common);
        _margin = WeighedMargin * extent.Box().HalfLength;
        Add(0, _boxes.Length, extent, common, 0);
    }

    private void Add(int first, int count, OrientedExtent extent, in CommonCourse common, int depth)
    {
        var index = _nodes.Count;
        _nodes.Add(new OrientedBoxNode(extent.Box(), first, count, 0));
        if (count <= OrientedBoxTree.LeafSize) return;
        var frame = common.Frame();
        var division = depth < DeepestUneven ? Best(first, count, frame) : default;
        if (division.Count == 0) division = InNumber(first, count, frame);
        else Arrange(first, count, frame, division);
        Add(first, division.Count, division.Extent, division.Common, depth + 1);
        _nodes[index] = _nodes[index] with { Second = _nodes.Count };
        Add(first + division.Count, count - division.Count, division.OtherExtent, division.OtherCommon, depth + 1);
    }

    /// <summary>The division with the smallest boxes, each weighed by its number of items; a division without items when no criterion separates them.</summary>
    private Division Best(int first, int count, in CourseFrame frame)
    {
        var best = default(Division);
        var least = double.PositiveInfinity;
        foreach (var criterion in Enum.GetValues<Criterion>())
        {
            var division = At(first, count, criterion, frame);
            if (division.Count == 0 || division.Count == count) continue;
            var cost = (division.Count * division.Extent.Area(_margin)) + ((count - division.Count) * division.OtherExtent.Area(_margin));
            if (!(cost < least)) continue;
            (best, least) = (division, cost);
        }

        return best;
    }

    /// <summary>Divides at the mean of a criterion: the items below it, and the others.</summary>
    private Division At(int first, int count, Criterion criterion, in CourseFrame frame)
    {
        var sum = 0.0;
        for (var slot = first; slot < first + count; slot++) sum += _keys[slot] = frame.Key(criterion, _boxes[_order[slot]]);
        var division = new Division { Criterion = criterion, Threshold = sum / count };
        for (var slot = first; slot < first + count; slot++)
        {
            if (!(_keys[slot] < division.Threshold))
            {
                division.OtherCommon.Add(_boxes[_order[slot]]);
                continue;
            }

            division.Common.Add(_boxes[_order[slot]]);
            division.Count++;
        }

        if (division.Count > 0 && division.Count < count) Enclose(first, count, ref division);
        return division;
    }

    /// <summary>Computes the boxes around both halves.</summary>
    private void Enclose(int first, int count, ref Division division)
    {
        var (own, ownPlaces) = division.Common.Extents();
        var (other, otherPlaces) = division.OtherCommon.Extents();
        for (var slot = first; slot < first + count; slot++)
        {
            ref readonly var box = ref _boxes[_order[slot]];
            if (_keys[slot] < division.Threshold)
            {
                own.Include(box);
                ownPlaces.Include(box);
            }
            else
            {
                other.Include(box);
                otherPlaces.Include(box);
            }
        }

        division.Extent = Smaller(own, ownPlaces);
        division.OtherExtent = Smaller(other, otherPlaces);
    }

    /// <summary>Brings the items of the first half to the front.</summary>
    private void Arrange(int first, int count, in CourseFrame frame, in Division division)
    {
        var (slot, end) = (first, first + count);
        while (slot < end)
        {
            if (frame.Key(division.Criterion, _boxes[_order[slot]]) < division.Threshold)
            {
                slot++;
                continue;
            }

            end--;
            (_order[slot], _order[end]) = (_order[end], _order[slot]);
        }
    }

    /// <summary>Divides into halves of equal number along the common direction.</summary>
    private Division InNumber(int first, int count, in CourseFrame frame)
    {
        for (var slot = first; slot < first + count; slot++) _keys[slot] = frame.Key(Criterion.PlaceAlong, _boxes[_order[slot]]);
        Array.Sort(_keys, _order, first, count);
        var division = new Division { Count = count / 2 };
        for (var slot = first; slot < first + division.Count; slot++) division.Common.Add(_boxes[_order[slot]]);
        for (var slot = first + division.Count; slot < first + count; slot++) division.OtherCommon.Add(_boxes[_order[slot]]);
        division.Extent = Fitted(first, division.Count, division.Common);
        division.OtherExtent = Fitted(first + division.Count, count - division.Count, division.OtherCommon);
        return division;
    }

    private OrientedExtent Fitted(int first, int count, in CommonCourse common)
    {
        var (own, places) = common.Extents();
        for (var slot = first; slot < first + count; slot++)
        {
            own.Include(_boxes[_order[slot]]);
            places.Include(_boxes[_order[slot]]);
        }

        return Smaller(own, places);
    }

    private OrientedExtent Smaller(in OrientedExtent one, in OrientedExtent other) => one.Area(_margin) <= other.Area(_margin) ? one : other;

    private enum Criterion
    {
        PlaceAlong,
        PlaceAcross,
        Direction,
    }

    private struct Division
    {
        public Criterion Criterion;
        public double Threshold;
        public int Count;
        public CommonCourse Common;
        public CommonCourse OtherCommon;
        public OrientedExtent Extent;
        public OrientedExtent OtherExtent;
    }

    /// <summary>Sums over boxes that give their common direction (angles doubled, so that a line and its reverse are the same) and the direction in which their
    /// centres are spread most.</summary>
    private struct CommonCourse
    {
        private Point2D _origin;
        private Vector2D _longest;
        private double _length;
        private double _cos;
        private double _sin;
        private double _weight;
        private double _x;
        private double _y;
        private double _spread;
        private double _skew;
        private int _count;

        public void Add(in OrientedBox box)
        {
            if (_count++ == 0) (_origin, _longest, _length) = (box.Centre, box.Along, box.HalfLength);
            if (box.HalfLength > _length) (_longest, _length) = (box.Along, box.HalfLength);
            _cos += box.HalfLength * ((box.Along.X * box.Along.X) - (box.Along.Y * box.Along.Y));
            _sin += box.HalfLength * 2.0 * box.Along.X * box.Along.Y;
            _weight += box.HalfLength;
            var spoke = box.Centre - _origin;
            (_x, _y) = (_x + spoke.X, _y + spoke.Y);
            _spread += (spoke.X * spoke.X) - (spoke.Y * spoke.Y);
            _skew += spoke.X * spoke.Y;
        }

        /// <summary>Two extents to choose from: along the common direction, and along the direction in which the centres are spread most.</summary>
        public readonly (OrientedExtent Own, OrientedExtent Places) Extents()
        {
            var spread = _spread - (((_x * _x) - (_y * _y)) / _count);
            var skew = _skew - (_x * _y / _count);
            return (new OrientedExtent(_origin, Along()), new OrientedExtent(_origin, HalfOf(spread, 2.0 * skew)));
        }

        public readonly CourseFrame Frame() => new(_origin, IsCommon ? Along() : _longest, IsCommon);

        private readonly bool IsCommon => (_cos * _cos) + (_sin * _sin) > MinCommon * MinCommon * _weight * _weight;

        private readonly Vector2D Along() => _weight > 0.0 ? HalfOf(_cos, _sin) : _longest;

        private static Vector2D HalfOf(double cos, double sin)
        {
            var half = Math.Atan2(sin, cos) / 2.0;
            return new Vector2D(Math.Cos(half), Math.Sin(half));
        }
    }

    /// <summary>Criteria by which the boxes of a node are divided: position along and across their common direction, and the signed angle to it; without a
    /// common direction, the angle to that of the longest box.</summary>
    private readonly record struct CourseFrame(Point2D Origin, Vector2D Along, bool IsCommon)
    {
        public double Key(Criterion criterion, in OrientedBox box)
        {
            if (criterion == Criterion.PlaceAlong) return (box.Centre - Origin).Dot(Along);
            if (criterion == Criterion.PlaceAcross) return Along.Cross(box.Centre - Origin);
            var (cos, sin) = (Along.Dot(box.Along), Along.Cross(box.Along));
            return IsCommon ? sin * Math.Sign(cos) : Math.Abs(sin);
        }
    }
}
