using Avalonia.Controls;

namespace Engraver.App.Jobs;

/// <summary>The palette of the job.</summary>
public partial class JobView : UserControl
{
    public JobView() => InitializeComponent();
}
