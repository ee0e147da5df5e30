using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Takes a program that comes in over a serial line: the other side of <see cref="ProgramSender"/>.</summary>
public sealed class ProgramReceiver(CharacterFrame frame)
{
    private readonly List<byte> _characters = [];

    /// <summary>Characters so far, NULs left out.</summary>
    public IReadOnlyList<byte> Characters => _characters;

    /// <summary>Characters whose parity was wrong; they are kept without it.</summary>
    public int Damaged { get; private set; }

    /// <summary>The line of the first of them, from 1; 0 for none.</summary>
    public int FirstDamagedLine { get; private set; }

    /// <summary>Line ends so far.</summary>
    public int Lines { get; private set; }

    /// <summary>Takes what was heard.</summary>
    public void Take(ReadOnlySpan<byte> heard)
    {
        foreach (var bits in heard)
        {
            var character = frame.Decode(bits);
            if (!frame.IsSound(bits) && Damaged++ == 0) FirstDamagedLine = Lines + 1;
            if (character == 0) continue;
            if (character == '\n' || _characters is [.., (byte)'\r']) Lines++;
            _characters.Add(character);
        }
    }

    /// <summary>Listens until nothing has come for a while (before the first character too), until the line ends, or until the operator stops it.</summary>
    /// <param name="silence">How long nothing has to come.</param>
    /// <param name="progress">Told after every piece, with the number of lines.</param>
    /// <returns>True when nothing more was coming; false when the operator stopped it before, so that what has come may be torn.</returns>
    /// <exception cref="IOException">The line is gone.</exception>
    public async Task<bool> ListenAsync(IProgramLine line, TimeSpan silence, IProgress<int>? progress, TimeProvider time, CancellationToken stop)
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
                Take(heard.AsSpan(0, count));
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
