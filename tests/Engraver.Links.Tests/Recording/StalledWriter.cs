using System.Text;

namespace Engraver.Links.Tests.Recording;

/// <summary>A file whose reader has stopped reading: a line is not written until the test has ended.</summary>
internal sealed class StalledWriter : TextWriter
{
    private readonly ManualResetEventSlim _over = new(); // not disposed: a writing thread may still be waking up

    public override Encoding Encoding => Encoding.UTF8;

    public override void WriteLine(string? value) => _over.Wait();

    protected override void Dispose(bool disposing)
    {
        _over.Set();
        base.Dispose(disposing);
    }
}
