using Engraver.Core.TextMarkup;
using Engraver.Shaping;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Fills one line. Between two tabs, items have their places from the start of this segment: at a centred or right tab stop, the segment moves to the
/// left as it grows.</summary>
internal sealed class LineBuilder(ParagraphMeasures paragraph)
{
    private readonly List<PlacedItem> _items = [];
    private double _left;
    private bool _isFirst;

    private int _segmentFirst;
    private double _segmentFrom;
    private (double Position, ParagraphAlignment Alignment)? _stop;
    private double _length;
    private double _inked;
    private bool _hasRightToLeft;

    public bool HasItems => _items.Count > 0;

    public void Start(bool isFirst)
    {
        _isFirst = isFirst;
        _left = isFirst ? paragraph.FirstLeft : paragraph.Left;
        _items.Clear();
        StartSegment(_left, null);
    }

    /// <summary>Right side of the letters if a word were added.</summary>
    /// <param name="inked">From the start of the word to the right side of its last letter.</param>
    public double EndWith(double inked)
    {
        var width = Math.Max(_inked, _length + inked);
        return SegmentStart(width) + width;
    }

    public void Add(LineItem item)
    {
        if (item.Kind == LineItemKind.Tab)
        {
            var at = EndSegment();
            _items.Add(new PlacedItem(item, at));
            StartSegment(at, paragraph.StopAfter(at));
            return;
        }

        _hasRightToLeft |= item.HasRightToLeft;
        Place(item);
    }

    /// <param name="height">Of letters at this place.</param>
    public SetLine Finish(SetLineEnd end, double height)
    {
        if (HasItems) height = _items[0].Item.Format.Height;
        while (end == SetLineEnd.Wrapped && HasItems && _items[^1].Item.IsGap) _items.RemoveAt(_items.Count - 1);
        _segmentFirst = Math.Min(_segmentFirst, _items.Count);
        EndSegment();
        return new SetLine(paragraph, [.. _items], _left, height, _isFirst, end);
    }

    private void StartSegment(double from, (double Position, ParagraphAlignment Alignment)? stop)
    {
        (_segmentFirst, _segmentFrom, _stop) = (_items.Count, from, stop);
        (_length, _inked, _hasRightToLeft) = (0.0, 0.0, false);
    }

    /// <summary>Places the items of the segment in the order in which they are seen.</summary>
    private void Reorder()
    {
        var items = _items.Skip(_segmentFirst).Select(place => place.Item).ToArray();
        _items.RemoveRange(_segmentFirst, items.Length);
        (_length, _inked) = (0.0, 0.0);
        foreach (var i in ComplexLine.OrderOf([.. items.Select(item => item.Text)])) Place(items[i]);
    }

    private void Place(LineItem item)
    {
        _items.Add(new PlacedItem(item, _length));
        if (item.HasInk) _inked = Math.Max(_inked, _length + item.Ink.Right);
        _length += item.Advance;
    }

    /// <summary>Places the items of the segment; returns the pen after it.</summary>
    private double EndSegment()
    {
        if (_hasRightToLeft) Reorder();
        var start = SegmentStart(_inked);
        for (var i = _segmentFirst; i < _items.Count; i++) _items[i] = _items[i] with { X = _items[i].X + start };
        return start + _length;
    }

    private double SegmentStart(double inked) => _stop switch
    {
        null => _segmentFrom,
        (var position, ParagraphAlignment.Right) => Math.Max(_segmentFrom, position - inked),
        (var position, ParagraphAlignment.Centre) => Math.Max(_segmentFrom, position - (inked / 2.0)),
        var (position, _) => position,
    };
}
