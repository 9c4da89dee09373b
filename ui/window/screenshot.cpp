// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/screenshot.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/views/slice_readout.h"
#include "ui/views/volume_view.h"
#include "ui/window/banner.h"
#include "ui/window/views.h"

namespace ui {

std::optional<ScreenshotWish> askForScreenshot(QWidget& window, Views& views,
                                               const SliceView* first) {
  QDialog dialog(&window);
  dialog.setWindowTitle(QObject::tr("Save picture"));
  auto* what = new QComboBox;
  what->setObjectName("pictureOf");
  what->addItem(QObject::tr("3-D view"));
  what->addItem(QObject::tr("Whole window"));
  std::vector<ScreenshotWish> wishes{{}, {.whole_window = true}};
  for (SliceView* slice : views.slices().slices()) {
    if (!slice->isVisible()) continue;
    what->addItem(QObject::tr("Slice: %1").arg(slice->readout().name));
    if (slice == first) what->setCurrentIndex(what->count() - 1);
    wishes.push_back({.slice = slice});
  }
  const auto chosen = [&] { return wishes[static_cast<std::size_t>(what->currentIndex())]; };
  auto* scale = new QComboBox;
  scale->setObjectName("pictureScale");
  const auto sizes = [&] {
    const ScreenshotWish wish = chosen();
    const QSize size = wish.whole_window ? window.size()
                       : wish.slice      ? wish.slice->size()
                                         : views.spaceSize();
    const int times = std::max(0, scale->currentIndex());
    scale->clear();
    for (int n = 1; n <= 4; ++n)
      scale->addItem(
          QObject::tr("%1x, %2 by %3 pixels").arg(n).arg(size.width() * n).arg(size.height() * n));
    scale->setCurrentIndex(times);
  };
  sizes();
  QObject::connect(what, &QComboBox::currentIndexChanged, &dialog, sizes);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* form = new QFormLayout;
  form->addRow(QObject::tr("Picture of"), what);
  form->addRow(QObject::tr("Size"), scale);
  auto* column = new QVBoxLayout(&dialog);
  column->addLayout(form);
  column->addWidget(buttons);
  if (dialog.exec() != QDialog::Accepted) return {};
  ScreenshotWish wish = chosen();
  wish.scale = scale->currentIndex() + 1;
  return wish;
}

QImage screenshotOf(QWidget& window, Views& views, const ScreenshotWish& wish) {
  if (wish.slice) return wish.slice->picture(wish.scale);
  // beside a slice that is shown alone the 3-D view has no place, and cards cover an empty one
  VolumeView& view = views.volume();
  const bool is_seen = !wish.whole_window || !view.visibleRegion().isEmpty();
  const QImage seen = is_seen ? views.spacePicture(wish.scale) : QImage();
  if (!wish.whole_window || (is_seen && seen.isNull())) return seen;
  QImage image(window.size() * wish.scale, QImage::Format_RGB32);
  image.setDevicePixelRatio(wish.scale);
  image.fill(window.palette().window().color());
  window.render(&image);
  if (is_seen) {
    // a widget that is rendered lacks what is drawn over the 3-D view
    QPainter painter(&image);
    const QSizeF size = views.spaceSize();
    const QPointF end = view.mapTo(&window, QPointF(view.width(), view.height()));
    painter.drawImage(QRectF({end.x() - size.width(), end.y() - size.height()}, size), seen);
    // and so does the picture, of what stands over the view
    for (auto* over : view.parentWidget()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      if (qobject_cast<VolumeView*>(over) == nullptr && over->isVisible() &&
          over->geometry().intersects(view.geometry()))
        over->render(&painter, over->mapTo(&window, QPoint{}), {}, QWidget::DrawChildren);
    for (auto* sentence : window.findChildren<Banner*>())
      if (sentence->isVisible())
        sentence->render(&painter, sentence->mapTo(&window, QPoint{}), {}, QWidget::DrawChildren);
  }
  image.setDevicePixelRatio(1.0);
  return image;
}

int screenScaleOf(const QWidget& widget) {
  return std::clamp(static_cast<int>(std::ceil(widget.devicePixelRatioF())), 1, 4);
}

}  // namespace ui
