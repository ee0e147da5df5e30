namespace Engraver.Simulator;

/// <summary>Everything that the axes and outputs did: one row for every sample of motion and one for every output change at rest (galil-dmc.md I.16).</summary>
/// <remarks>Thread safe. Rows lie in chunks; a span of constant speed is kept as its closed form. When a motion begins at a position that no row has, a row
/// with that position comes first.
/// A record that keeps no rows still passes them to its listeners and its file.</remarks>
public sealed class MotionRecord
{
    private readonly Lock _gate = new();
    private readonly Lock _csvGate = new();
    private readonly RowStore _rows = new();
    private readonly List<IMotionListener> _listeners = [];
    private readonly bool _isKept;
    private RecordCsv? _csv;

    internal MotionRecord(bool isKept) => _isKept = isKept;

    /// <summary>Rows kept so far, those within spans included.</summary>
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

    /// <summary>A copy of all kept rows, oldest first.</summary>
    public IReadOnlyList<MotionSample> Snapshot()
    {
        lock (_gate)
        {
            return [.. _rows.From(0)];
        }
    }

    /// <summary>From here on the listener is called with every row, on the thread that computes it; it must be quick and must not call the
    /// controller.</summary>
    /// <returns>Dispose it to end the subscription.</returns>
    public IDisposable Subscribe(IMotionListener listener)
    {
        ArgumentNullException.ThrowIfNull(listener);
        lock (_gate)
        {
            _listeners.Add(listener);
        }

        return new Subscription(this, listener);
    }

    /// <summary>Writes the header now, and all rows, also those already kept, whenever <see cref="FlushCsv"/> runs (the controller does so every few
    /// milliseconds and when it is disposed).</summary>
    /// <param name="writer">The record owns it from now on, and closes it when the controller is disposed.</param>
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

    /// <summary>Writes the rows that wait and closes the file; later rows are not written. Safe beside a <see cref="FlushCsv"/> on another thread, which writes
    /// before the file is closed or not at all.</summary>
    /// <exception cref="IOException">Writing fails; the file is closed all the same.</exception>
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

    /// <summary>Writes the rows that wait to the attached file and flushes it to the operating system. Does nothing without a file, and after the controller
    /// was disposed.</summary>
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

    /// <summary>Writes header and all kept rows: <c>t,a,b,c,d,outputs</c>, t in seconds, positions in counts, outputs as a decimal byte.</summary>
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
