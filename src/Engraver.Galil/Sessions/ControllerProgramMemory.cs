using System.Globalization;
using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Borrows the controller's program memory: its content is uploaded and stored, and restored at the end (galil-dmc.md A.6).</summary>
public sealed class ControllerProgramMemory(ControllerSession session)
{
    private const string OwnThreads = "_XQ0,_XQ1";

    /// <summary>Threads to halt; a controller with fewer threads refuses the command, which is ignored.</summary>
    private const string AllThreads = OwnThreads + ",_XQ2,_XQ3,_XQ4,_XQ5,_XQ6,_XQ7";

    private const int MaxHalts = 4;

    private string? _found;

    /// <summary>Latin-1: one character is one byte of the memory, independent of the encoding of its comments.</summary>
    public static Encoding CopyEncoding => Encoding.Latin1;

    /// <summary>Reads the content of the memory without changing it.</summary>
    public ValueTask<Reply> ReadProgramAsync(CancellationToken cancellation) => session.Commands.UploadAsync(cancellation);

    /// <summary>Stores a copy of the found program in a file, downloads <paramref name="program"/> and compares the memory with it.</summary>
    /// <param name="found">The program to restore at the end.</param>
    /// <param name="copyPath">File for it, in case this program dies; null for none.</param>
    /// <returns>The refusal, or null when the program is in the memory.</returns>
    /// <exception cref="ProtocolViolationException">The memory's content differs from the sent program.</exception>
    /// <exception cref="IOException">The copy could not be written; the memory is unchanged.</exception>
    public async Task<Rejected?> BorrowAsync(string program, string found, string? copyPath, CancellationToken cancellation)
    {
        if (copyPath is not null) await File.WriteAllTextAsync(copyPath, found + "\n", CopyEncoding, cancellation).ConfigureAwait(false);
        _found = found;
        return await ReplaceAsync(program, cancellation).ConfigureAwait(false);
    }

    /// <summary>Replaces the content of the borrowed memory by another program. No thread may run.</summary>
    /// <returns>The refusal, or null when the program is in the memory.</returns>
    /// <exception cref="ProtocolViolationException">The memory's content differs from the sent program.</exception>
    public Task<Rejected?> SwapAsync(string program, CancellationToken cancellation) => ReplaceAsync(program, cancellation);

    /// <summary>Restores the found program; an empty memory is an empty download. No thread may run. Does nothing when the memory was not borrowed.</summary>
    public async Task<Rejected?> GiveBackAsync(CancellationToken cancellation)
    {
        if (_found is null) return null;
        var refusal = await ReplaceAsync(_found, cancellation).ConfigureAwait(false);
        if (refusal is null) _found = null;
        return refusal;
    }

    private async Task<Rejected?> ReplaceAsync(string program, CancellationToken cancellation)
    {
        if (await HaltAsync(cancellation).ConfigureAwait(false) is { } running) return running;
        if (await session.Commands.DownloadAsync(program, cancellation).ConfigureAwait(false) is Rejected refused) return refused;
        var check = await session.Commands.UploadAsync(cancellation, program.Length + program.Count(character => character == '\n')).ConfigureAwait(false);
        if (check is not Accepted { Data: var stored }) return check as Rejected;
        return ProgramText.AreEquivalent(program, stored) ? null : throw new ProtocolViolationException(Wording.Get("ProgramMemory.UploadDiffers"));
    }

    /// <summary>While a thread runs DL is refused with TC 17, and the program after it would be executed as commands (galil-dmc.md A.6): a thread of this
    /// program that still runs is halted again.</summary>
    /// <returns>The refusal that a download would get; null when no thread runs.</returns>
    private async Task<Rejected?> HaltAsync(CancellationToken cancellation)
    {
        if (session.Line is not null) return null; // on a serial line each halt was compared with its echo, and a query takes as long as a segment
        for (var tries = 0; await RunningThreadAsync(cancellation).ConfigureAwait(false) is { } thread; tries++)
        {
            if (tries == MaxHalts || thread is not (ResidentProgram.MainThread or ResidentProgram.WatchdogThread))
                return new Rejected(TcCode.DownloadWhileProgramRunning, Wording.Get("ProgramMemory.ThreadRunning", thread), "DL");
            await session.Commands.SendAsync(string.Create(CultureInfo.InvariantCulture, $"HX{thread}"), cancellation).ConfigureAwait(false);
        }

        return null;
    }

    private async Task<int?> RunningThreadAsync(CancellationToken cancellation)
    {
        var lines = await session.Commands.ReadAsync(AllThreads, cancellation).ConfigureAwait(false);
        if (lines.Refusal is not null) lines = await session.Commands.ReadAsync(OwnThreads, cancellation).ConfigureAwait(false);
        return lines.Values.ToList().FindIndex(line => line >= 0) is >= 0 and var thread ? thread : null;
    }
}
