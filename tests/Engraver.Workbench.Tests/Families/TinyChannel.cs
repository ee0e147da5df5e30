using System.Text;
using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Tests.Families;

/// <summary>The plotter's protocol: one command a line, one line as the answer.</summary>
internal sealed class TinyChannel(IControllerLink link, IWireTrace? trace) : IAsyncDisposable
{
    private readonly SemaphoreSlim _turn = new(1);

    /// <exception cref="ControllerLinkException">The link was closed.</exception>
    public async Task<string> AskAsync(string command, CancellationToken cancellation)
    {
        await _turn.WaitAsync(cancellation);
        try
        {
            trace?.Write("T", '>', command);
            await link.WriteAsync(Encoding.ASCII.GetBytes(command + "\n"), cancellation);
            var (answer, one) = (new StringBuilder(), new byte[1]);
            while (await link.ReadAsync(one, cancellation) == 1 && one[0] != '\n') answer.Append((char)one[0]);
            if (one[0] != '\n') throw new ControllerLinkException($"The link to {link.Description} was closed.");
            trace?.Write("T", '<', answer.ToString());
            return answer.ToString();
        }
        finally
        {
            _turn.Release();
        }
    }

    public async ValueTask DisposeAsync()
    {
        await link.DisposeAsync();
        _turn.Dispose();
    }
}
