using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Receives a program over a serial line, as sent by <see cref="ProgramSender"/>.</summary>
public sealed class ProgramReceiver(CharacterFrame frame)
{
    private readonly List<byte> _characters = [];

    /// <summary>Received characters without NUL.</summary>
    public IReadOnlyList<byte> Characters => _characters;

    /// <summary>Number of characters with a parity error; they are kept without the parity bit.</summary>
    public int Damaged { get; private set; }

    /// <summary>Line of the first parity error, from 1; 0 for none.</summary>
    public int FirstDamagedLine { get; private set; }

    /// <summary>Number of received line ends.</summary>
    public int Lines { get; private set; }

    /// <summary>Processes received bytes.</summary>
    public void Add(ReadOnlySpan<byte> heard)
    {
        foreach (var bits in heard)
        {
            var character = frame.Decode(bits);
            if (!frame.HasValidParity(bits) && Damaged++ == 0) FirstDamagedLine = Lines + 1;
            if (character == 0) continue;
            if (character == '\n' || _characters is [.., (byte)'\r']) Lines++;
            _characters.Add(character);
        }
    }

    /// <summary>Listens until the line is silent for a time (also before the first character), is closed, or the operator stops.</summary>
    /// <param name="silence">Duration of silence that ends the reception.</param>
    /// <param name="progress">Receives the number of lines after every block.</param>
    /// <returns>True after silence; false if the operator stopped, so that the program may be incomplete.</returns>
    /// <exception cref="IOException">The port failed.</exception>
    public async Task<bool> ListenAsync(IProgramPort line, TimeSpan silence, IProgress<int>? progress, TimeProvider time, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(line);
        var heard = new byte[512];
        using var quiet = new CancellationTokenSource(silence, time);
        using var either = CancellationTokenSource.CreateLinkedTokenSource(stop, quiet.Token);
        try
        {
            while (await line.ReadAsync(heard, either.Token).ConfigureAwait(false) is > 0 and var count)
            {
                quiet.CancelAfter(silence);
                Add(heard.AsSpan(0, count));
                progress?.Report(Lines);
            }

            return true;
        }
        catch (OperationCanceledException)
        {
            return !stop.IsCancellationRequested;
        }
    }
}
