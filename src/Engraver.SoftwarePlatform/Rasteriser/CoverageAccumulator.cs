using System.Numerics;
using System.Runtime.CompilerServices;
using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Exact area coverage by signed areas: every line adds, to the cells it crosses, how far it changes the covered part of everything right of it.
/// A running sum along a row is then the winding number times the covered area. One bit per touched cell makes sorting unnecessary.</summary>
/// <remarks>Buffers are kept between shapes and are all zero between them. Not thread safe.</remarks>
internal sealed unsafe class CoverageAccumulator
{
    private const double CurveTolerance = 0.02;

    private float[] _changes = [];
    private ulong[] _touched = [];
    private byte[] _cells = [];
    private PixelBounds _bounds;
    private int _stride;
    private int _wordsPerRow;
    private int _firstRow;
    private int _endRow;

    /// <summary>Starts a shape. A line outside the bounds counts only for what it covers to its right.</summary>
    public void Begin(PixelBounds bounds)
    {
        _bounds = bounds;
        _stride = bounds.Width + 2;
        _wordsPerRow = (_stride + 63) >> 6;
        _firstRow = int.MaxValue;
        _endRow = 0;
        if (_changes.Length < _stride * bounds.Height)
            _changes = new float[_stride * bounds.Height];
        if (_touched.Length < _wordsPerRow * bounds.Height)
            _touched = new ulong[_wordsPerRow * bounds.Height];
        if (_cells.Length < _stride)
            _cells = new byte[_stride];
    }

    public void Add(VectorPath path, in Matrix transform)
    {
        var toCells = transform * Matrix.CreateTranslation(-_bounds.Left, -_bounds.Top);
        var sink = new LineSink(this);
        PathWalk.Walk(path, toCells, CurveTolerance, ref sink);
        sink.Close();
    }

    /// <summary>Gives the coverage of everything added since <see cref="Begin"/> and clears the buffers.</summary>
    public void Emit<TSink>(ref TSink sink, FillRule rule)
        where TSink : struct, ICoverageSink
    {
        fixed (float* changes = _changes)
        fixed (ulong* touched = _touched)
        {
            for (var row = _firstRow; row < _endRow; row++)
                EmitRow(ref sink, row, changes + row * _stride, touched + row * _wordsPerRow, rule == FillRule.EvenOdd);
        }
    }

    private void EmitRow<TSink>(ref TSink sink, int row, float* changes, ulong* touched, bool isEvenOdd)
        where TSink : struct, ICoverageSink
    {
        var gatherer = new RunGatherer<TSink>(_cells, row + _bounds.Top, _bounds.Left);
        var sum = 0f;
        var start = 0;
        byte coverage = 0;
        for (var word = 0; word < _wordsPerRow; word++)
        {
            var bits = touched[word];
            touched[word] = 0;
            for (; bits != 0; bits &= bits - 1)
            {
                var cell = (word << 6) + BitOperations.TrailingZeroCount(bits);
                sum += changes[cell];
                changes[cell] = 0;
                var next = Coverage(sum, isEvenOdd);
                if (next == coverage)
                    continue;
                gatherer.Add(ref sink, start, Math.Min(cell, _bounds.Width), coverage);
                start = cell;
                coverage = next;
            }
        }
        gatherer.Add(ref sink, start, _bounds.Width, coverage);
        gatherer.Flush(ref sink);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static byte Coverage(float sum, bool isEvenOdd)
    {
        var area = MathF.Abs(sum);
        if (isEvenOdd)
        {
            area -= 2 * MathF.Floor(area * 0.5f);
            area = area > 1 ? 2 - area : area;
        }
        return (byte)(Math.Min(area, 1) * 255f + 0.5f);
    }

    private void AddLine(double x0, double y0, double x1, double y1)
    {
        if (y0 == y1 || !double.IsFinite(x0 + x1 + y0 + y1))
            return;
        var direction = 1f;
        if (y0 > y1)
        {
            (x0, x1, y0, y1) = (x1, x0, y1, y0);
            direction = -1;
        }
        if (y1 <= 0 || y0 >= _bounds.Height)
            return;
        var slope = (x1 - x0) / (y1 - y0);
        if (y0 < 0)
        {
            x0 -= y0 * slope;
            y0 = 0;
        }
        AddRows(x0, y0, Math.Min(y1, _bounds.Height), slope, direction);
    }

    private void AddRows(double x, double top, double bottom, double slope, float direction)
    {
        int first = (int)top, end = (int)Math.Ceiling(bottom);
        _firstRow = Math.Min(_firstRow, first);
        _endRow = Math.Max(_endRow, end);
        fixed (float* changes = _changes)
        fixed (ulong* touched = _touched)
        {
            for (var row = first; row < end; row++)
            {
                var height = Math.Min(row + 1, bottom) - Math.Max(row, top);
                var next = x + slope * height;
                AddPiece(changes + row * _stride, touched + row * _wordsPerRow, (float)Math.Min(x, next), (float)Math.Max(x, next), (float)height * direction);
                x = next;
            }
        }
    }

    /// <summary>A piece of a line inside one row, from <paramref name="left"/> to <paramref name="right"/>, of signed height.</summary>
    private void AddPiece(float* changes, ulong* touched, float left, float right, float height)
    {
        float width = _bounds.Width;
        if (left >= width)
            return;
        if (right <= 0)
        {
            changes[0] += height;
            touched[0] |= 1;
            return;
        }
        if (left < 0)
        {
            var outside = height * (-left / (right - left));
            changes[0] += outside;
            touched[0] |= 1;
            height -= outside;
            left = 0;
        }
        if (right > width)
        {
            height -= height * ((right - width) / (right - left));
            right = width;
        }
        AddInside(changes, touched, left, right, height);
    }

    private static void AddInside(float* changes, ulong* touched, float left, float right, float height)
    {
        var first = (int)left;
        var end = (int)MathF.Ceiling(right);
        if (end <= first + 1)
        {
            var late = height * (0.5f * (left + right) - first);
            changes[first] += height - late;
            changes[first + 1] += late;
            Touch(touched, first);
            Touch(touched, first + 1);
            return;
        }
        var perCell = height / (right - left);
        var inFirst = first + 1 - left;
        var inLast = right - (end - 1);
        var before = 0.5f * perCell * inFirst * inFirst;
        changes[first] += before;
        Touch(touched, first);
        for (var cell = first + 1; cell < end - 1; cell++)
        {
            var until = perCell * (inFirst + (cell - first - 1) + 0.5f);
            changes[cell] += until - before;
            before = until;
            Touch(touched, cell);
        }
        var untilLast = perCell * (inFirst + (end - 2 - first) + inLast * (1 - 0.5f * inLast));
        changes[end - 1] += untilLast - before;
        changes[end] += height - untilLast;
        Touch(touched, end - 1);
        Touch(touched, end);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Touch(ulong* touched, int cell) => touched[cell >> 6] |= 1UL << (cell & 63);

    private struct LineSink(CoverageAccumulator owner) : IPolylineSink
    {
        private double _x;
        private double _y;
        private double _startX;
        private double _startY;

        public void MoveTo(double x, double y)
        {
            Close();
            (_startX, _startY) = (_x, _y) = (x, y);
        }

        public void LineTo(double x, double y)
        {
            owner.AddLine(_x, _y, x, y);
            (_x, _y) = (x, y);
        }

        public void Close()
        {
            owner.AddLine(_x, _y, _startX, _startY);
            (_x, _y) = (_startX, _startY);
        }
    }
}

/// <summary>Takes the coverage of a filled shape, row by row from the top, left to right, without overlaps. 255 is fully covered.</summary>
internal interface ICoverageSink
{
    /// <summary>Equal coverage from <paramref name="left"/> up to, not including, <paramref name="right"/>.</summary>
    void Run(int y, int left, int right, byte coverage);

    /// <summary>One coverage per pixel from <paramref name="left"/> on.</summary>
    void Cells(int y, int left, ReadOnlySpan<byte> coverages);
}
