using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>Borrows the controller's program memory: what stands in it is uploaded and kept, and written back at the end (galil-dmc.md A.6).</summary>
public sealed class ProgramMemory(ControllerSession session)
{
    private string? _found;

    /// <summary>Uploads what is there, keeps a copy in a file, downloads <paramref name="program"/> and compares it with what then stands in the memory.</summary>
    /// <param name="copyPath">Where the found program is kept in case this program dies; null for nowhere.</param>
    /// <param name="isOurs">Whether a found program is one of ours, left behind by a run that died: what that run had found lies in its copy, and that is given back.</param>
    /// <returns>The refusal, or null when the program stands in the memory.</returns>
    /// <exception cref="ProtocolViolationException">The memory holds something else than what was sent.</exception>
    /// <exception cref="IOException">The copy could not be written; the memory is untouched.</exception>
    public async Task<Rejected?> BorrowAsync(string program, string? copyPath, Func<string, bool> isOurs, CancellationToken cancellation)
    {
        var upload = await session.Commands.UploadAsync(cancellation).ConfigureAwait(false);
        if (upload is not Accepted { Data: var found }) return upload as Rejected;
        if (copyPath is not null && isOurs(found) && File.Exists(copyPath)) found = await File.ReadAllTextAsync(copyPath, cancellation).ConfigureAwait(false);
        else if (copyPath is not null) await File.WriteAllTextAsync(copyPath, found + "\n", cancellation).ConfigureAwait(false);
        _found = found;
        return await ReplaceAsync(program, cancellation).ConfigureAwait(false);
    }

    /// <summary>Replaces the borrowed memory's content by another program of ours. No thread may run.</summary>
    /// <returns>The refusal, or null when the program stands in the memory.</returns>
    /// <exception cref="ProtocolViolationException">The memory holds something else than what was sent.</exception>
    public Task<Rejected?> SwapAsync(string program, CancellationToken cancellation) => ReplaceAsync(program, cancellation);

    /// <summary>Writes back what was found; an empty memory is an empty download. No thread may run. Does nothing when nothing was borrowed.</summary>
    public async Task<Rejected?> GiveBackAsync(CancellationToken cancellation)
    {
        if (_found is null) return null;
        var refusal = await ReplaceAsync(_found, cancellation).ConfigureAwait(false);
        if (refusal is null) _found = null;
        return refusal;
    }

    private async Task<Rejected?> ReplaceAsync(string program, CancellationToken cancellation)
    {
        if (await session.Commands.DownloadAsync(program, cancellation).ConfigureAwait(false) is Rejected refused) return refused;
        var check = await session.Commands.UploadAsync(cancellation).ConfigureAwait(false);
        if (check is not Accepted { Data: var stored }) return check as Rejected;
        return ProgramText.AreSame(program, stored) ? null : throw new ProtocolViolationException("The program memory does not hold what was downloaded; the upload differs.");
    }
}
