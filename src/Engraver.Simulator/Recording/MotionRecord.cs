using System.Globalization;

namespace Engraver.Simulator;

/// <summary>Everything the axes and outputs did: one row for every sample of motion and one for every output change at rest (galil-dmc.md I.16).</summary>
/// <remarks>Thread safe. Rows lie in chunks, so that hours of motion neither copy nor fragment. The first row of a motion away from an unrecorded place is that place.</remarks>
public sealed class MotionRecord
{
    private const int ChunkSize = 1 << 15;
    private readonly Lock _gate = new();
    private readonly Lock _csvGate = new();
    private readonly List<MotionSample[]> _chunks = [];
    private int _count;
    private TextWriter? _csv;
    private int _written;

    /// <summary>Rows so far.</summary>
    public int Count
    {
        get
        {
            lock (_gate)
            {
                return _count;
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
                ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, _count);
                return _chunks[index / ChunkSize][index % ChunkSize];
            }
        }
    }

    /// <summary>A copy of all rows, oldest first.</summary>
    public IReadOnlyList<MotionSample> Snapshot()
    {
        lock (_gate)
        {
            return Copy(0, _count);
        }
    }

    /// <summary>Writes the header now and from here on every row, also those already recorded, whenever <see cref="FlushCsv"/> runs (the controller does so every few milliseconds and when it is disposed).</summary>
    public void AttachCsv(TextWriter writer)
    {
        ArgumentNullException.ThrowIfNull(writer);
        lock (_csvGate)
        {
            _csv = writer;
            _written = 0;
            WriteHeader(writer);
        }

        FlushCsv();
    }

    /// <summary>Brings the attached file up to date, through to the operating system.</summary>
    public void FlushCsv()
    {
        lock (_csvGate)
        {
            if (_csv is null || _written == Count) return;

            MotionSample[] rows;
            lock (_gate)
            {
                rows = Copy(_written, _count - _written);
            }

            WriteRows(_csv, rows);
            _csv.Flush();
            _written += rows.Length;
        }
    }

    /// <summary>Writes header and all rows: <c>t,a,b,c,d,outputs</c>, t in seconds, positions in counts, outputs as a decimal byte.</summary>
    public void WriteCsv(TextWriter writer)
    {
        ArgumentNullException.ThrowIfNull(writer);
        WriteHeader(writer);
        WriteRows(writer, Snapshot());
        writer.Flush();
    }

    internal void Append(in MotionSample sample)
    {
        lock (_gate)
        {
            if (_count == _chunks.Count * ChunkSize) _chunks.Add(new MotionSample[ChunkSize]);

            _chunks[_count / ChunkSize][_count % ChunkSize] = sample;
            _count++;
        }
    }

    private static void WriteHeader(TextWriter writer) => writer.Write("t,a,b,c,d,outputs\n");

    private static void WriteRows(TextWriter writer, IReadOnlyList<MotionSample> rows)
    {
        Span<char> line = stackalloc char[96];
        for (var i = 0; i < rows.Count; i++)
        {
            var row = rows[i];
            var fits = line.TryWrite(
                CultureInfo.InvariantCulture,
                $"{row.Sample / 1000}.{row.Sample % 1000:000},{row.A},{row.B},{row.C},{row.D},{row.Outputs}\n",
                out var length);
            System.Diagnostics.Debug.Assert(fits, "five integers and a time always fit");
            writer.Write(line[..length]);
        }
    }

    private MotionSample[] Copy(int first, int length)
    {
        var rows = new MotionSample[length];
        for (var done = 0; done < length;)
        {
            var index = first + done;
            var part = Math.Min(length - done, ChunkSize - (index % ChunkSize));
            Array.Copy(_chunks[index / ChunkSize], index % ChunkSize, rows, done, part);
            done += part;
        }

        return rows;
    }
}
