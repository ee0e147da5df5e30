using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Links;

/// <summary>A link whose replies can be withheld: the host waits for a prompt that does not come.</summary>
internal sealed class WithheldLink(IControllerLink inner) : IControllerLink
{
    private readonly TaskCompletionSource _waiting = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource _released = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private volatile bool _withhold;

    public string Description => inner.Description;

    public SerialLine? Line => inner.Line;

    /// <summary>Completes when the host waits for a withheld reply.</summary>
    public Task HasWaiter => _waiting.Task;

    public void Withhold() => _withhold = true;

    /// <summary>Delivers the withheld bytes, and from now on everything.</summary>
    public void Release()
    {
        _withhold = false;
        _released.TrySetResult();
    }

    /// <summary>Called with each line before it is sent.</summary>
    public Action<string>? Sending { get; set; }

    /// <summary>Returns the bytes that the controller receives instead of a line, including its CR; null leaves every line unchanged.</summary>
    public Func<string, string>? Corrupt { get; set; }

    /// <summary>Returns the bytes that the host receives instead of the sent ones; null leaves them unchanged.</summary>
    public Func<string, string>? Repair { get; set; }

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var line = Encoding.Latin1.GetString(bytes.Span);
        Sending?.Invoke(line);
        return inner.WriteAsync(Corrupt is { } harm ? Encoding.Latin1.GetBytes(harm(line)) : bytes, cancellation);
    }

    public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
    {
        if (!_withhold) return Repaired(buffer, await inner.ReadAsync(buffer, cancellation));
        _waiting.TrySetResult();
        await _released.Task.WaitAsync(cancellation);
        return Repaired(buffer, await inner.ReadAsync(buffer, cancellation));
    }

    private int Repaired(Memory<byte> buffer, int count) =>
        Repair is { } mend ? Encoding.Latin1.GetBytes(mend(Encoding.Latin1.GetString(buffer.Span[..count])), buffer.Span) : count;

    public ValueTask DisposeAsync() => inner.DisposeAsync();
}
