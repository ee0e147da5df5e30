using Engraver.Core.Machines;

namespace Engraver.Links;

/// <summary>A link to a controller that shares its clock: every reply over it means that the clock may have advanced.</summary>
/// <param name="link">Owned by this link.</param>
/// <param name="heard">Called with each reply.</param>
public sealed class ClockedLink(IControllerLink link, Action heard) : IControllerLink
{
    public string Description => link.Description;

    public SerialLine? Line => link.Line;

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => link.WriteAsync(bytes, cancellation);

    public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
    {
        var count = await link.ReadAsync(buffer, cancellation).ConfigureAwait(false);
        heard();
        return count;
    }

    public ValueTask DisposeAsync() => link.DisposeAsync();
}
