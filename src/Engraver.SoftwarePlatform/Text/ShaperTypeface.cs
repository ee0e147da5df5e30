using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>The shaper keeps what it needs in <see cref="SoftwareTypeface"/>; Avalonia wants an object of its own nevertheless.</summary>
internal sealed class ShaperTypeface : ITextShaperTypeface
{
    public void Dispose()
    {
    }
}
