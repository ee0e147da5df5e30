using System.Globalization;
using System.Text;
using System.Threading.Channels;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Tests.Families;

/// <summary>A plotter in memory: <c>ID</c>, <c>AT</c>, <c>UP</c>, <c>DOWN</c>, <c>GO x y</c>, <c>MARK n</c>. It moves at once.</summary>
internal sealed class TinyPlotter
{
    private readonly Lock _guard = new();
    private readonly List<string> _done = [];
    private (long X, long Y) _at;
    private int _mark;

    /// <summary>Commands that moved the pen, in order.</summary>
    public IReadOnlyList<string> Done
    {
        get
        {
            lock (_guard) return [.. _done];
        }
    }

    public IControllerLink Open() => new Link(this);

    private string Answer(string line)
    {
        lock (_guard)
        {
            var words = line.Split(' ');
            if (words[0] is "UP" or "DOWN" or "GO") _done.Add(line);
            if (words[0] == "GO") _at = (long.Parse(words[1], CultureInfo.InvariantCulture), long.Parse(words[2], CultureInfo.InvariantCulture));
            if (words[0] == "MARK") _mark = int.Parse(words[1], CultureInfo.InvariantCulture);
            return words[0] switch { "ID" => "TINY-1", "AT" => string.Create(CultureInfo.InvariantCulture, $"{_at.X} {_at.Y} {_mark}"), _ => "OK" };
        }
    }

    private sealed class Link(TinyPlotter plotter) : IControllerLink
    {
        private readonly Channel<byte> _answers = Channel.CreateUnbounded<byte>();
        private readonly StringBuilder _line = new();

        public string Description => "tiny://bench";

        public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
        {
            foreach (var one in bytes.Span)
            {
                if (one != '\n')
                {
                    _line.Append((char)one);
                    continue;
                }

                foreach (var letter in Encoding.ASCII.GetBytes(plotter.Answer(_line.ToString()) + "\n")) _answers.Writer.TryWrite(letter);
                _line.Clear();
            }

            return ValueTask.CompletedTask;
        }

        public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
        {
            if (!await _answers.Reader.WaitToReadAsync(cancellation)) return 0;
            var one = await _answers.Reader.ReadAsync(cancellation);
            buffer.Span[0] = one;
            return 1;
        }

        public ValueTask DisposeAsync()
        {
            _answers.Writer.TryComplete();
            return ValueTask.CompletedTask;
        }
    }
}
