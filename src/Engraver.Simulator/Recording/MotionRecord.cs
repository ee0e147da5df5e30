namespace Engraver.Simulator;

/// <summary>The complete motion of the axes and all output changes: one row for every sample of motion and one for every output change at rest (galil-dmc.md
/// I.16).</summary>
/// <remarks>Thread safe. Rows are stored in chunks; a span of constant speed is stored in closed form. When a motion starts at a position that is in no row, a
/// row with that position is recorded first.
/// A record that stores no rows still passes them to its listeners and its file.</remarks>
public sealed class MotionRecord
{
    private readonly Lock _gate = new();
    private readonly Lock _csvGate = new();
    private readonly RowStore _rows = new();
    private readonly List<IMotionListener> _listeners = [];
    private readonly bool _isKept;
    private RecordCsv? _csv;

    internal MotionRecord(bool isKept) => _isKept = isKept;

    /// <summary>Rows stored so far, including those within spans.</summary>
    public int Count
    {
        get
        {
            lock (_gate)
            {
                return checked((int)_rows.Count);
            }
        }
    }

    public MotionSample this[int index]
    {
        get
        {
            lock (_gate)
            {
                ArgumentOutOfRangeException.ThrowIfNegative(index);
                ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, _rows.Count);
                return _rows[index];
            }
        }
    }

    /// <summary>A copy of all stored rows, oldest first.</summary>
    public IReadOnlyList<MotionSample> Snapshot()
    {
        lock (_gate)
        {
            return [.. _rows.From(0)];
        }
    }

    /// <summary>From now on the listener is called with every row, on the thread that computes it; it must return quickly and must not call the
    /// controller.</summary>
    /// <returns>The subscription; dispose it to stop listening.</returns>
    public IDisposable Subscribe(IMotionListener listener)
    {
        ArgumentNullException.ThrowIfNull(listener);
        lock (_gate)
        {
            _listeners.Add(listener);
        }

        return new Subscription(this, listener);
    }

    /// <summary>Writes the header now, and all rows, including those already stored, whenever <see cref="FlushCsv"/> runs (the controller calls it every few
    /// milliseconds and when it is disposed).</summary>
    /// <param name="writer">The record owns the writer from now on and closes it when the controller is disposed.</param>
    public void AttachCsv(TextWriter writer)
    {
        ArgumentNullException.ThrowIfNull(writer);
        lock (_csvGate)
        {
            RecordCsv.WriteHeader(writer);
            lock (_gate)
            {
                _csv = new RecordCsv(writer, [.. _rows.Parts()]);
            }
        }

        FlushCsv();
    }

    /// <summary>Writes the pending rows and closes the file; later rows are not written. Can run at the same time as a <see cref="FlushCsv"/> on another
    /// thread, which writes before the file is closed or not at all.</summary>
    /// <exception cref="IOException">Writing fails; the file is closed nevertheless.</exception>
    internal void CompleteCsv()
    {
        lock (_csvGate)
        {
            RecordCsv? csv;
            lock (_gate)
            {
                (csv, _csv) = (_csv, null);
            }

            csv?.Complete();
        }
    }

    /// <summary>Writes the pending rows to the attached file and flushes it to the operating system. Does nothing without a file or after the controller is
    /// disposed.</summary>
    public void FlushCsv()
    {
        lock (_csvGate)
        {
            RecordCsv csv;
            List<RowStore.RecordPart> waiting;
            lock (_gate)
            {
                if (_csv is not { HasWaiting: true } attached) return;
                csv = attached;
                waiting = csv.TakeWaiting();
            }

            csv.Write(waiting);
        }
    }

    /// <summary>Writes the header and all stored rows: <c>t,a,b,c,d,outputs</c>, t in seconds, positions in counts, outputs as a decimal byte.</summary>
    public void WriteCsv(TextWriter writer)
    {
        ArgumentNullException.ThrowIfNull(writer);
        RecordCsv.WriteHeader(writer);
        RecordCsv.WriteRows(writer, Snapshot());
        writer.Flush();
    }

    internal void Append(in MotionSample sample)
    {
        lock (_gate)
        {
            if (_isKept) _rows.Add(sample);
            _csv?.Add(sample);
            foreach (var listener in _listeners) listener.Add(sample);
        }
    }

    internal void Append(MotionSpan span)
    {
        lock (_gate)
        {
            if (_isKept) _rows.Add(span);
            _csv?.Add(span);
            foreach (var listener in _listeners) listener.Add(span);
        }
    }

    private sealed class Subscription(MotionRecord record, IMotionListener listener) : IDisposable
    {
        public void Dispose()
        {
            lock (record._gate)
            {
                record._listeners.Remove(listener);
            }
        }
    }
}
