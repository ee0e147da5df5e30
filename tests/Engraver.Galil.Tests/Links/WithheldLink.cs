using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Links;

/// <summary>A link whose replies can be held back: the host waits for a prompt that does not come.</summary>
internal sealed class WithheldLink(IControllerLink inner) : IControllerLink
{
    private readonly TaskCompletionSource _waiting = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource _released = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private volatile bool _withhold;

    public string Description => inner.Description;

    public SerialLine? Line => inner.Line;

    /// <summary>Completes when somebody waits for a reply that is held back.</summary>
    public Task SomebodyWaits => _waiting.Task;

    public void Withhold() => _withhold = true;

    /// <summary>What was held back comes now, and from here on everything.</summary>
    public void Release()
    {
        _withhold = false;
        _released.TrySetResult();
    }

    /// <summary>Called with each line before it goes out.</summary>
    public Action<string>? Sending { get; set; }

    /// <summary>What arrives instead of a line, its CR included; null leaves every line as it is.</summary>
    public Func<string, string>? Harm { get; set; }

    /// <summary>What the host sees instead of what comes; null leaves it as it is.</summary>
    public Func<string, string>? Mend { get; set; }

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var line = Encoding.Latin1.GetString(bytes.Span);
        Sending?.Invoke(line);
        return inner.WriteAsync(Harm is { } harm ? Encoding.Latin1.GetBytes(harm(line)) : bytes, cancellation);
    }

    public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
    {
        if (!_withhold) return Mended(buffer, await inner.ReadAsync(buffer, cancellation));
        _waiting.TrySetResult();
        await _released.Task.WaitAsync(cancellation);
        return Mended(buffer, await inner.ReadAsync(buffer, cancellation));
    }

    private int Mended(Memory<byte> buffer, int count) =>
        Mend is { } mend ? Encoding.Latin1.GetBytes(mend(Encoding.Latin1.GetString(buffer.Span[..count])), buffer.Span) : count;

    public ValueTask DisposeAsync() => inner.DisposeAsync();
}
