namespace Engraver.Cli.Tests.Runs;

/// <summary>The operator's input: Enter some times, then Ctrl-C instead of Enter: that line never arrives.</summary>
/// <param name="answers">How often Enter is pressed.</param>
internal sealed class StoppingReader(CancellationTokenSource stop, int answers = 0) : TextReader
{
    private readonly ManualResetEventSlim _closed = new();
    private int _left = answers;

    public override string? ReadLine()
    {
        if (_left-- > 0) return "";
        stop.Cancel();
        _closed.Wait();
        return null;
    }

    protected override void Dispose(bool disposing)
    {
        _closed.Set();
        base.Dispose(disposing);
    }
}
