using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>Draws lines into a tile. The coverage of a pixel depends on how far its centre is inside a bar with round ends: from 0 half a pixel outside the
/// edge to 1 half a pixel inside.</summary>
/// <remarks>The coverage of a pixel depends only on the line, not on the tile, so that tiles meet without a seam. Computed in double: ends may be a billion
/// pixels away.</remarks>
internal static class LineRasteriser
{
    /// <summary>Lines no longer than this in x and y are drawn by <see cref="DrawShort"/>, pixels.</summary>
    private const double ShortLine = 3.0;

    /// <summary>Pixel coordinates of the picture; colour 0xAARRGGBB with A = 255.</summary>
    public static void Draw(PixelTile tile, double fromX, double fromY, double toX, double toY, uint colour, LinePen pen)
    {
        if (!pen.IsDashed && Math.Abs(toX - fromX) <= ShortLine && Math.Abs(toY - fromY) <= ShortLine)
        {
            DrawShort(tile, fromX, fromY, toX, toY, colour & 0xFFFFFF, pen.Reach);
            return;
        }

        var steep = Math.Abs(toY - fromY) > Math.Abs(toX - fromX);
        var bar = steep
            ? new WideLine(fromY, fromX, toY, toX, pen)
            : new WideLine(fromX, fromY, toX, toY, pen);
        var area = steep
            ? new Area(tile.Top, tile.Height, tile.Left, tile.Width, PixelTile.Side, 1)
            : new Area(tile.Left, tile.Width, tile.Top, tile.Height, 1, PixelTile.Side);
        var (first, last) = bar.Columns(area);
        if (first > last) return;
        Fill(tile.Layer, area, bar, first, last, colour & 0xFFFFFF);
        var (top, bottom) = steep ? (first, last) : bar.Rows(area, first, last);
        tile.MarkDirty(top - tile.Top, bottom - tile.Top);
    }

    /// <summary>The few pixels around a line of at most <see cref="ShortLine"/>: a large drawing shown as a whole consists only of such lines.</summary>
    private static void DrawShort(PixelTile tile, double fromX, double fromY, double toX, double toY, uint colour, double reach)
    {
        var left = Math.Max(tile.Left, (int)Math.Ceiling(Math.Max(Math.Min(fromX, toX), tile.Left - 100.0) - reach - 0.5));
        var right = Math.Min(tile.Left + tile.Width - 1, (int)Math.Floor(Math.Min(Math.Max(fromX, toX), tile.Left + 1000.0) + reach - 0.5));
        var top = Math.Max(tile.Top, (int)Math.Ceiling(Math.Max(Math.Min(fromY, toY), tile.Top - 100.0) - reach - 0.5));
        var bottom = Math.Min(tile.Top + tile.Height - 1, (int)Math.Floor(Math.Min(Math.Max(fromY, toY), tile.Top + 1000.0) + reach - 0.5));
        if (left > right || top > bottom) return;
        var (wayX, wayY) = (toX - fromX, toY - fromY);
        var squared = (wayX * wayX) + (wayY * wayY);
        var (shareX, shareY) = squared > 0.0 ? (wayX / squared, wayY / squared) : (0.0, 0.0);
        for (var row = top; row <= bottom; row++)
        {
            var line = tile.Layer.AsSpan(((row - tile.Top) * PixelTile.Side) + left - tile.Left, right - left + 1);
            var (offX, offY) = (left + 0.5 - fromX, row + 0.5 - fromY);
            for (var i = 0; i < line.Length; i++, offX += 1.0)
            {
                var share = Math.Clamp((offX * shareX) + (offY * shareY), 0.0, 1.0);
                var (restX, restY) = (offX - (share * wayX), offY - (share * wayY));
                var away = (restX * restX) + (restY * restY);
                if (away < reach * reach) RaiseCoverage(ref line[i], colour, reach - Math.Sqrt(away));
            }
        }

        tile.MarkDirty(top - tile.Top, bottom - tile.Top);
    }

    private static void Fill(uint[] layer, in Area area, in WideLine bar, int first, int last, uint colour)
    {
        ref var origin = ref MemoryMarshal.GetArrayDataReference(layer);
        for (var column = first; column <= last; column++)
        {
            var u = column + 0.5;
            var middle = bar.MiddleAt(u);
            var low = Math.Max(area.MinV, (int)Math.Ceiling(Math.Max(middle - bar.Span, area.MinV - 1.0) - 0.5));
            var high = Math.Min(area.MaxV, (int)Math.Floor(Math.Min(middle + bar.Span, area.MaxV + 1.0) - 0.5));
            if (low > high) continue;
            var at = ((column - area.MinU) * area.StepU) + ((low - area.MinV) * area.StepV);
            var inner = bar.IsInner(u);
            for (var row = low; row <= high; row++, at += area.StepV)
            {
                var coverage = inner ? bar.InnerCoverage(row + 0.5 - middle) : bar.Coverage(u, row + 0.5);
                if (coverage > 0.0) RaiseCoverage(ref Unsafe.Add(ref origin, at), colour, coverage);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void RaiseCoverage(ref uint pixel, uint colour, double coverage)
    {
        var level = coverage >= 1.0 ? 255u : (uint)((coverage * 255.0) + 0.5);
        if (level != 0 && level >= pixel >> 24) pixel = (level << 24) | colour;
    }

    /// <summary>The tile in coordinates of a line: u is the longer direction of the line, v the other.</summary>
    private readonly struct Area(int minU, int countU, int minV, int countV, int stepU, int stepV)
    {
        public int MinU { get; } = minU;

        public int MaxU { get; } = minU + countU - 1;

        public int MinV { get; } = minV;

        public int MaxV { get; } = minV + countV - 1;

        public int StepU { get; } = stepU;

        public int StepV { get; } = stepV;
    }

    /// <summary>A line with its width; u increases from the first end to the second.</summary>
    private readonly struct WideLine
    {
        private readonly double _u0;
        private readonly double _v0;
        private readonly double _u1;
        private readonly double _alongU;
        private readonly double _alongV;
        private readonly double _length;
        private readonly double _slope;
        private readonly double _reach;
        private readonly double _innerFrom;
        private readonly double _innerTo;
        private readonly bool _turned;
        private readonly LinePen _pen;

        public WideLine(double u0, double v0, double u1, double v1, LinePen pen)
        {
            _turned = u0 > u1;
            if (_turned) (u0, v0, u1, v1) = (u1, v1, u0, v0);
            (_u0, _v0, _u1, _pen) = (u0, v0, u1, pen);
            var (du, dv) = (u1 - u0, v1 - v0);
            _length = Math.Sqrt((du * du) + (dv * dv));
            (_alongU, _alongV) = _length > 0.0 ? (du / _length, dv / _length) : (1.0, 0.0);
            _slope = du > 0.0 ? dv / du : 0.0;
            _reach = pen.Reach;
            Span = _reach / _alongU;
            var ends = Span + _reach; // maximum distance of the foot of a pixel from its column
            (_innerFrom, _innerTo) = (u0 + ends, u1 - ends);
        }

        /// <summary>Distance above and below the middle of the line within which pixels are touched.</summary>
        public double Span { get; }

        public double MiddleAt(double u) => _v0 + ((Math.Clamp(u, _u0, _u1) - _u0) * _slope);

        /// <summary>Both ends are so far away that only the distance from the line counts.</summary>
        public bool IsInner(double u) => u > _innerFrom && u < _innerTo && !_pen.IsDashed;

        public double InnerCoverage(double offset) => _reach - (Math.Abs(offset) * _alongU);

        public double Coverage(double u, double v)
        {
            var (du, dv) = (u - _u0, v - _v0);
            var along = (du * _alongU) + (dv * _alongV);
            var nearest = Math.Clamp(along, 0.0, _length);
            if (!_pen.IsOn(_turned ? _length - nearest : nearest)) return 0.0;
            var (restU, restV) = (du - (nearest * _alongU), dv - (nearest * _alongV));
            return _reach - Math.Sqrt((restU * restU) + (restV * restV));
        }

        /// <summary>Columns of the area in which the line can touch a pixel.</summary>
        public (int First, int Last) Columns(in Area area)
        {
            var (from, to) = (_u0 - _reach, _u1 + _reach);
            if (_slope != 0.0)
            {
                var atLow = _u0 + ((area.MinV - Span - 1.0 - _v0) / _slope);
                var atHigh = _u0 + ((area.MaxV + 1.0 + Span + 1.0 - _v0) / _slope);
                from = Math.Max(from, Math.Min(atLow, atHigh) - _reach);
                to = Math.Min(to, Math.Max(atLow, atHigh) + _reach);
            }
            else if (_v0 + Span < area.MinV || _v0 - Span > area.MaxV + 1.0)
            {
                return (0, -1);
            }

            var first = Math.Max(area.MinU, Math.Ceiling(from - 0.5));
            var last = Math.Min(area.MaxU, Math.Floor(to - 0.5));
            return first <= last ? ((int)first, (int)last) : (0, -1);
        }

        /// <summary>Rows of the area between the line's positions in two columns, including its width.</summary>
        public (int First, int Last) Rows(in Area area, int first, int last)
        {
            var (a, b) = (MiddleAt(first + 0.5), MiddleAt(last + 0.5));
            var low = Math.Clamp(Math.Min(a, b) - Span - 1.0, area.MinV, area.MaxV);
            var high = Math.Clamp(Math.Max(a, b) + Span + 1.0, area.MinV, area.MaxV);
            return ((int)low, (int)high);
        }
    }
}
