using Engraver.Core.Posts;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Reads a program back on another thread, and shows the command's progress.</summary>
internal static class ReadBackProgress
{
    public static async Task<T> ShowAsync<T>(CommandProgress shown, Func<IProgress<ReplayProgress>, Task<T>> read, CancellationToken cancellation)
    {
        try
        {
            return await Task.Run(() => read(new ReplayFraction(shown)), cancellation).ConfigureAwait(false);
        }
        finally
        {
            shown.End();
        }
    }

    private sealed class ReplayFraction(CommandProgress shown) : IProgress<ReplayProgress>
    {
        public void Report(ReplayProgress value) => shown.Report(value.Fraction);
    }
}
