using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Verification;

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
