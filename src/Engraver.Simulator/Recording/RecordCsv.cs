using System.Globalization;

namespace Engraver.Simulator;

/// <summary>The file of a record: buffers rows until they are written, spans in closed form. Not thread safe.</summary>
internal sealed class RecordCsv(TextWriter writer, List<RowStore.RecordPart> waiting)
{
    private List<RowStore.RecordPart> _waiting = waiting;

    public bool HasWaiting => _waiting.Count > 0;

    public static void WriteHeader(TextWriter writer) => writer.Write("t,a,b,c,d,outputs\n");

    public static void WriteRows(TextWriter writer, IEnumerable<MotionSample> rows)
    {
        foreach (var row in rows) WriteRow(writer, row);
    }

    public void Add(in MotionSample row) => _waiting.Add(new RowStore.RecordPart(row, null));

    public void Add(MotionSpan span) => _waiting.Add(new RowStore.RecordPart(span.Last, span));

    public List<RowStore.RecordPart> TakeWaiting()
    {
        var taken = _waiting;
        _waiting = [];
        return taken;
    }

    /// <summary>Writes the buffered rows and flushes them to the operating system.</summary>
    public void Write(List<RowStore.RecordPart> parts)
    {
        foreach (var (row, span) in parts)
        {
            if (span is null) WriteRow(writer, row);
            for (var i = 0L; i < span?.Count; i++) WriteRow(writer, span[i]);
        }

        writer.Flush();
    }

    /// <summary>Writes the buffered rows and closes the file, also when writing fails.</summary>
    public void Complete()
    {
        using (writer) Write(TakeWaiting());
    }

    private static void WriteRow(TextWriter writer, in MotionSample row)
    {
        Span<char> line = stackalloc char[96];
        var fits = line.TryWrite(
            CultureInfo.InvariantCulture,
            $"{row.Sample / 1000}.{row.Sample % 1000:000},{row.A},{row.B},{row.C},{row.D},{row.Outputs}\n",
            out var length);
        System.Diagnostics.Debug.Assert(fits, "five integers and a time always fit");
        writer.Write(line[..length]);
    }
}
