using Engraver.Core.Machines;

namespace Engraver.Links;

/// <summary>A link to a controller whose clock is offered: every answer over it shows that the clock may have advanced.</summary>
/// <param name="link">Owned by this link.</param>
/// <param name="heard">Called with each answer.</param>
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
